// Bad input: one line on stderr that says where, what is wrong and what would be right, and the exit code of
// the interface; nothing is written, and what was there stays.

#include "cli/command.h"
#include "cli/small_scenes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <unistd.h>

namespace vkpt::test {
namespace {

enum class When { BeforeLoading, BeforeRendering };

struct Refusal {
  const char* name;
  std::vector<std::string> arguments;
  ExitCode code;
  std::vector<const char*> says; ///< parts of the one line
  When when = When::BeforeRendering;
};
void PrintTo(const Refusal& r, std::ostream* out) { *out << r.name; }

/// Files that are wrong, each in its way, and an image from yesterday.
void plant(const WorkFolder& folder) {
  folder.write("good.obj", kSquare);
  folder.write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  folder.write("back.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n");
  folder.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("infinite.obj", "v 0 0 0\n\nv 0 inf 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("pointless.obj", "v 0 0 0\nv 1 0 0\n");
  folder.write("empty.obj", "");
  folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  folder.write("short.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n");
  folder.write("half.obj", "v 0 0 0\nv 1 0\n");
  folder.write("nomtl.obj", "mtllib gone.mtl\nusemtl brick\n" + kSquare);
  folder.write("sliver.obj", kSquare + "f 1 1 2\n");
  folder.write("badmtl.obj", "mtllib bad.mtl\nusemtl a\n" + kSquare);
  folder.write("bad.mtl", "newmtl a\nKd 0.5 0.5\n");
  folder.write("scene.xyz", "");
  folder.write("old.png", "yesterday's image");
  fs::create_directory(folder / "folder.obj");
  fs::create_directory(folder / "folder.png");
  fs::create_symlink("/nonexistent", folder / "dangling.obj");
}

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithOneLineAndItsExitCode) {
  const Refusal& c = GetParam();
  const WorkFolder folder;
  plant(folder);
  const auto before = folder.names();
  const CommandResult r = vkpt(c.arguments, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, static_cast<int>(c.code)) << r.err;
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  for (const char* part : c.says)
    EXPECT_NE(r.errors().front().find(part), std::string::npos) << part << "\nis not in\n" << r.err;
  EXPECT_TRUE(r.otherLines().empty()) << r.err;
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(folder.names(), before);
  EXPECT_EQ(folder.read("old.png"), "yesterday's image");
  if (c.when == When::BeforeLoading) {
    EXPECT_TRUE(r.warnings().empty()) << r.err;
    EXPECT_LT(r.seconds, 1.0);
  }
}

std::string nameOf(const testing::TestParamInfo<Refusal>& info) { return info.param.name; }

using enum ExitCode;
// clang-format off
const std::vector<Refusal> kScenes{
    {"MissingFile", {"gone.obj"}, Scene, {"gone.obj: no such file; a scene is an .obj file or", "cornell"}},
    {"MissingSecondFile", {"good.obj", "gone.obj"}, Scene, {"gone.obj: no such file"}},
    {"DanglingLink", {"dangling.obj"}, Scene, {"dangling.obj: no such file"}},
    {"Folder", {"folder.obj"}, Scene, {"folder.obj: is a folder; name an .obj file in it"}},
    {"UnknownSceneFormat", {"scene.xyz"}, Scene, {"scene.xyz: unknown extension '.xyz'", ".obj"}},
    {"MistypedBuiltin", {"cornel-spheres"}, Scene, {"cornel-spheres: no such file", "cornell-spheres"}},
    {"IndexOutOfRange", {"range.obj"}, Scene, {"range.obj:4: vertex index 9 is out of range; the file has 3"}},
    {"IndexBeforeTheFirst", {"back.obj"}, Scene, {"back.obj:4: vertex index -4 is out of range; 3 vertices"}},
    {"NanVertex", {"nan.obj"}, Scene, {"nan.obj:2: vertex coordinate 'nan' is not finite; give a number"}},
    {"InfiniteVertex", {"infinite.obj"}, Scene, {"infinite.obj:3: vertex coordinate 'inf' is not finite"}},
    {"NoFaces", {"pointless.obj"}, Scene, {"pointless.obj: no faces (2 vertices); give at least one 'f' line"}},
    {"EmptyFile", {"empty.obj"}, Scene, {"empty.obj: no faces"}},
    {"NoArea", {"flat.obj"}, Scene, {"flat.obj: no faces with an area", "give at least one"}},
    {"TwoCorners", {"short.obj"}, Scene, {"short.obj:3: a face with 2 corners; it needs 3 or more"}},
    {"HalfAVertex", {"half.obj"}, Scene, {"half.obj:2:", "a vertex needs three numbers"}},
    {"BadMaterial", {"badmtl.obj"}, Scene, {"bad.mtl:2:", "Kd needs three numbers"}},
    {"StrictMissingMaterials", {"nomtl.obj", "--strict"}, Scene, {"nomtl.obj:1: material file 'gone.mtl'", "--strict"}},
    {"StrictDegenerateTriangle", {"sliver.obj", "--strict", "--background", "1,1,1"}, Scene, {"sliver.obj:6: 1 triangle of zero area dropped", "--strict"}},
    {"StrictNoLight", {"good.obj", "--strict"}, Scene, {"good: no light", "--background", "--strict"}},
};
INSTANTIATE_TEST_SUITE_P(Scene, Refused, testing::ValuesIn(kScenes), nameOf);

constexpr When kAtOnce = When::BeforeLoading;
// Each names a scene that is missing: it is not even looked for.
const std::vector<Refusal> kOutputs{
    {"MissingFolder", {"gone.obj", "-o", "none/x.png"}, Usage, {"none/x.png: the folder none does not exist; create it or name another"}, kAtOnce},
    {"Folder", {"gone.obj", "-o", "folder.png"}, Usage, {"folder.png: is a folder; name a file in it"}, kAtOnce},
    {"FileAsFolder", {"gone.obj", "-o", "old.png/x.png"}, Usage, {"old.png is not a folder"}, kAtOnce},
    {"UnknownExtension", {"gone.obj", "-o", "x.bmp"}, Usage, {"x.bmp: unknown image format; use .png, .exr, .hdr or .pfm"}, kAtOnce},
    {"NoExtension", {"gone.obj", "-o", "image"}, Usage, {"image: unknown image format; use .png"}, kAtOnce},
    {"SecondIsBad", {"gone.obj", "-o", "old.png", "-o", "x.bmp"}, Usage, {"x.bmp: unknown image format"}, kAtOnce},
    {"NoName", {"gone.obj", "-o", ""}, Usage, {"--output '': expected a file name"}, kAtOnce},
    {"Twice", {"gone.obj", "-o", "x.png", "-o", "./x.png"}, Usage, {"./x.png: written twice"}, kAtOnce},
    {"NotWritable", {"gone.obj", "-o", "/proc/x.png"}, Usage, {"/proc/x.png: cannot make a file in the folder /proc"}, kAtOnce},
    {"NameTooLong", {"gone.obj", "-o", std::string(300, 'x') + ".png"}, Usage, {".png: cannot be written: File name too long"}, kAtOnce},
    {"StatsInMissingFolder", {"gone.obj", "--stats", "none/x.json"}, Usage, {"none/x.json: the folder none does not exist"}, kAtOnce},
    {"StatsOverAScene", {"--stats", "good.obj"}, Usage, {"--stats 'good.obj': expected a name that ends in .json"}, kAtOnce},
    {"StatsNameTooLong", {"--stats", std::string(300, 'x') + ".json"}, Usage, {"File name too long"}, kAtOnce},
    {"TooManyPixelsForPng", {"good.obj", "--size", "33554432x1", "-o", "x.png"}, Usage, {"x.png: 33554432x1 pixels are too many for .png; use .exr or .pfm"}},
};
INSTANTIATE_TEST_SUITE_P(Output, Refused, testing::ValuesIn(kOutputs), nameOf);

const std::vector<Refusal> kOptions{
    {"UnknownOption", {"--frmes", "4"}, Usage, {"--frmes: unknown option, did you mean '--frames'?; see vkpt --help"}, kAtOnce},
    {"UnknownShortOption", {"-q"}, Usage, {"-q: unknown option"}, kAtOnce},
    {"MissingValue", {"good.obj", "--validation", "--frames"}, Usage, {"--frames"}, kAtOnce},
    {"GivenTwice", {"--frames", "1", "--frames", "2"}, Usage, {"--frames"}, kAtOnce},
    {"QuietAndVerbose", {"--quiet", "--verbose"}, Usage, {"--quiet and --verbose contradict each other"}, kAtOnce},
    {"DevicesOfAScene", {"devices", "good.obj"}, Usage, {"devices 'good.obj': the command takes no scene"}, kAtOnce},
    {"SelftestOfNoCase", {"selftest", "--case", "d4-slap"}, Usage, {"--case d4-slap: no such case, did you mean 'd4-slab'?; see vkpt selftest --list"}, kAtOnce},
    {"SelftestOfAFilesCase", {"selftest", "a.xml", "--case", "d4-slab"}, Usage, {"go with the hard cases, not with a file"}, kAtOnce},
    {"SelftestOfAnUnknownOption", {"selftest", "--kase", "d4-slab"}, Usage, {"--kase: unknown option"}, kAtOnce},
    {"SelftestOfTwo", {"selftest", "a.xml", "b.xml"}, Usage, {"selftest: give one file of tests"}, kAtOnce},
    {"SelftestOfAScene", {"selftest", "good.obj"}, Scene, {"good.obj: is no file of tests; give a Nori .xml file"}, kAtOnce},
    {"SelftestOfAMissingFile", {"selftest", "gone.xml"}, Scene, {"gone.xml: no such file"}, kAtOnce},
    {"SizeOfZero", {"--size", "0x5"}, Usage, {"--size '0x5': expected WxH with both above 0, e.g. 512x512"}, kAtOnce},
    {"SizeOfOneNumber", {"--size", "5"}, Usage, {"--size '5': expected WxH"}, kAtOnce},
    {"SizeOfThree", {"--size", "5x5x5"}, Usage, {"--size '5x5x5': expected WxH"}, kAtOnce},
    {"SizeNegative", {"--size", "-5x5"}, Usage, {"--size '-5x5': expected WxH"}, kAtOnce},
    {"SizeEmpty", {"--size", ""}, Usage, {"--size '': expected WxH"}, kAtOnce},
    {"SizeBeyondInt", {"--size", "99999999999x5"}, Usage, {"--size '99999999999x5': expected WxH"}, kAtOnce},
    {"SizeBeyondTheDevice", {"good.obj", "--size", "100000x100000", "-o", "x.exr"}, Usage, {"--size 100000x100000", "at most"}},
    {"FramesZero", {"--frames", "0"}, Usage, {"--frames '0': expected a whole number from 1 to"}, kAtOnce},
    {"FramesNegative", {"--frames", "-3"}, Usage, {"--frames '-3': expected a whole number from 1 to"}, kAtOnce},
    {"FramesWord", {"--frames", "abc"}, Usage, {"--frames 'abc': expected a whole number from 1 to"}, kAtOnce},
    {"FramesFraction", {"--frames", "1.5"}, Usage, {"--frames '1.5': expected a whole number from 1 to"}, kAtOnce},
    {"FramesTooMany", {"--frames", "99999999999"}, Usage, {"--frames '99999999999': expected"}, kAtOnce},
    {"TimeNegative", {"--time", "-1"}, Usage, {"--time '-1': expected seconds, above 0"}, kAtOnce},
    {"TimeZero", {"--time", "0"}, Usage, {"--time '0': expected seconds, above 0"}, kAtOnce},
    {"TimeNan", {"--time", "nan"}, Usage, {"--time 'nan': expected seconds, above 0"}, kAtOnce},
    {"TimeInfinite", {"--time", "inf"}, Usage, {"--time 'inf': expected seconds, above 0"}, kAtOnce},
    {"TimeWithUnit", {"--time", "2s"}, Usage, {"--time '2s': expected seconds, above 0"}, kAtOnce},
    {"TargetErrorZero", {"--target-error", "0"}, Usage, {"--target-error '0': expected a relative error above 0"}, kAtOnce},
    {"TargetErrorNan", {"--target-error", "nan"}, Usage, {"--target-error 'nan': expected a relative error"}, kAtOnce},
    {"SeedNegative", {"--seed", "-1"}, Usage, {"--seed '-1': expected a whole number from 0 to 4294967295"}, kAtOnce},
    {"SeedTooLarge", {"--seed", "4294967296"}, Usage, {"--seed '4294967296': expected"}, kAtOnce},
    {"BatchTooLarge", {"--batch", "17"}, Usage, {"--batch '17': expected a whole number from 1 to 16"}, kAtOnce},
    {"BackgroundOfTwo", {"--background", "1,2"}, Usage, {"--background '1,2': expected three radiances R,G,B"}, kAtOnce},
    {"BackgroundNegative", {"--background", "-1,0,0"}, Usage, {"--background '-1,0,0': expected three radiances"}, kAtOnce},
    {"BackgroundNan", {"--background", "nan,0,0"}, Usage, {"--background 'nan,0,0': expected three radiances"}, kAtOnce},
    {"BackgroundBeyondFloat", {"--background", "1e39,0,0"}, Usage, {"--background '1e39,0,0': expected three radiances"}, kAtOnce},
    {"LookAtOfTwo", {"--look-at", "1,2"}, Usage, {"--look-at '1,2': expected eye and target"}, kAtOnce},
    {"LookAtItself", {"--look-at", "1,2,3,1,2,3"}, Usage, {"--look-at '1,2,3,1,2,3': expected eye and target, two different points"}, kAtOnce},
    {"LookAtAlongUp", {"good.obj", "--look-at", "0,0,0,0,1,0"}, Usage, {"up vector is parallel to its view; give another --up"}},
    {"UpAlongView", {"good.obj", "--up", "0,0,1"}, Usage, {"up vector is parallel to its view; give another --up"}},
    {"UpZero", {"--up", "0,0,0"}, Usage, {"--up '0,0,0': expected a direction"}, kAtOnce},
    {"FovZero", {"--fov", "0"}, Usage, {"--fov '0': expected degrees above 0 and below 180"}, kAtOnce},
    {"FovFlat", {"--fov", "180"}, Usage, {"--fov '180': expected degrees above 0 and below 180"}, kAtOnce},
    {"FovNan", {"--fov", "nan"}, Usage, {"--fov 'nan': expected degrees above 0 and below 180"}, kAtOnce},
    {"ExposureInfinite", {"--exposure", "inf"}, Usage, {"--exposure 'inf': expected a finite number"}, kAtOnce},
    {"TonemapUnknown", {"--tonemap", "filmic"}, Usage, {"--tonemap 'filmic': expected none or srgb or aces"}, kAtOnce},
    {"LightUnknown", {"--light", "sun"}, Usage, {"--light 'sun': expected nee or bsdf"}, kAtOnce},
    {"RouletteUnknown", {"--roulette", "red"}, Usage, {"--roulette 'red': expected albedo, throughput or constant=Q"}, kAtOnce},
    {"RouletteTerminationAboveOne", {"--roulette", "constant=1.5"}, Usage, {"--roulette 'constant=1.5': expected constant=Q with a probability Q above 0, at most 1"}, kAtOnce},
    {"RouletteTerminationZero", {"--roulette", "constant=0"}, Usage, {"--roulette 'constant=0': expected constant=Q with a probability Q above 0, at most 1"}, kAtOnce},
    {"LightSamplesTooMany", {"--light-samples", "17"}, Usage, {"--light-samples '17': expected a whole number from 1 to 16"}, kAtOnce},
    {"SplitTooDeep", {"--split", "17"}, Usage, {"--split '17': expected a whole number from 0 to 16"}, kAtOnce},
    {"PathsUnknown", {"--paths", "caustic,glow"}, Usage, {"--paths 'glow': expected emission or direct or caustic or indirect or indirect-caustic or specular"}, kAtOnce},
    {"FilterUnknown", {"--filter", "sinc"}, Usage, {"--filter 'sinc': expected box or tent or gaussian or mitchell"}, kAtOnce},
    {"MaxBouncesNegative", {"--max-bounces", "-1"}, Usage, {"--max-bounces '-1': expected a whole number from 0 to"}, kAtOnce},
    {"DeviceUnknown", {"good.obj", "--device", "abacus"}, Device, {"--device 'abacus': no such Vulkan device; there is 0 '"}},
    {"DeviceIndexUnknown", {"good.obj", "--device", "99"}, Device, {"--device '99': no such Vulkan device; there is 0 '"}},
};
// clang-format on
INSTANTIATE_TEST_SUITE_P(Option, Refused, testing::ValuesIn(kOptions), nameOf);

TEST(Refused, FileWithoutPermission) {
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may read everything";
  const WorkFolder folder;
  folder.write("secret.obj", kSquare);
  fs::permissions(folder / "secret.obj", fs::perms::none);
  const CommandResult r = vkpt({"secret.obj"}, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 2);
  ASSERT_EQ(r.errors().size(), 1U) << r.err;
  EXPECT_NE(r.err.find("secret.obj: cannot be read; check its permissions"), std::string::npos) << r.err;
}

TEST(Refused, WithoutAVulkanDevice) {
  const WorkFolder folder;
  const std::map<std::string, std::string> noDriver{{"VK_ICD_FILENAMES", "/nonexistent"},
                                                    {"VK_DRIVER_FILES", "/nonexistent"}};
  for (const bool validation : {false, true}) {
    for (const char* command : {"cornell", "devices"}) {
      const CommandResult r = vkpt({command}, {folder.path(), noDriver, validation});
      EXPECT_EQ(r.exitCode, 3) << command;
      ASSERT_EQ(r.errors().size(), 1U) << r.err;
      EXPECT_EQ(r.errors().front(),
                "no Vulkan device; install a driver, or mesa-vulkan-drivers for software Vulkan");
      EXPECT_TRUE(r.otherLines().empty()) << r.err;
      EXPECT_TRUE(folder.names().empty());
    }
  }
}

} // namespace
} // namespace vkpt::test
