// Every fault of a file: exit code 2 and one line with file, line, what is wrong and what would be right.

#include "unit/scene/scene_check.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

struct BadText {
  const char* name;
  std::string obj;
  std::string mtl;
  std::string expected; ///< with file and line
};

void PrintTo(const BadText& bad, std::ostream* out) { *out << bad.name; }

class BadTextTest : public testing::TestWithParam<BadText> {};

TEST_P(BadTextTest, IsOneLineWithFileAndLine) {
  const std::string what = errorOfText(GetParam().obj, GetParam().mtl);
  EXPECT_NE(what.find(GetParam().expected), std::string::npos) << "message: " << what;
}

const std::string kHead = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

const std::vector<BadText> kBadObj{
    {"IndexAboveRange", kHead + "f 1 2 3\nf 1 2 4\n", "",
     "scene.obj:5: vertex index 4 is out of range; the file has 3 vertices"},
    {"IndexBelowRange", kHead + "f -1 -2 -4\nv 1 1 1\n", "",
     "scene.obj:4: vertex index -4 is out of range; 3 vertices stand above it"},
    {"IndexZero", kHead + "f 0 1 2\n", "", "scene.obj:4: index 0 in '0' is out of range; the first is 1"},
    {"NormalIndexZero", kHead + "vn 0 0 1\nf 1//0 2//1 3//1\n", "",
     "scene.obj:5: index 0 in '1//0' is out of range"},
    {"NormalAboveRange", kHead + "vn 0 0 1\nf 1//1 2//1 3//2\n", "",
     "scene.obj:5: normal index 2 is out of range; the file has 1 normal"},
    {"NormalWithoutAny", kHead + "f 1//1 2//1 3//1\n", "",
     "scene.obj:4: normal index 1 is out of range; the file has 0"},
    {"TextureAboveRange", kHead + "vt 0 0\nf 1/1 2/1 3/2\n", "",
     "scene.obj:5: texture coordinate index 2 is out of range"},
    {"IndexHuge", kHead + "f 1 2 99999999999\n", "",
     "scene.obj:4: index 99999999999 in '99999999999' is out of range"},
    {"IndexLargestInt", kHead + "f 1 2 2147483647\n", "",
     "scene.obj:4: vertex index 2147483647 is out of range"},
    {"IndexSmallestInt", kHead + "f 1 2 -2147483648\n", "",
     "scene.obj:4: vertex index -2147483648 is out of range"},
    {"IndexNoNumber", kHead + "f 1 2 x\n", "",
     "scene.obj:4: 'x' in corner 'x' is no index; a corner is v, v/t, v//n or v/t/n"},
    {"IndexFraction", kHead + "f 1 2 3.5\n", "", "scene.obj:4: '3.5' in corner '3.5' is no index"},
    {"CornerWithoutVertex", kHead + "f 1 2 /3\n", "", "scene.obj:4: '' in corner '/3' is no index"},
    {"CornerOfFourParts", kHead + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3\n", "",
     "scene.obj:6: '1/1/1/1' has too many parts"},
    {"FaceOfTwo", kHead + "f 1 2\n", "", "scene.obj:4: a face with 2 corners; it needs 3 or more"},
    {"FaceOfNone", kHead + "f\n", "", "scene.obj:4: a face with 0 corners"},
    {"NanVertex", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "",
     "scene.obj:2: vertex coordinate 'nan' is not finite; give a number"},
    {"InfiniteVertex", "# a\r\nv 0 0 -inf\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "",
     "scene.obj:2: vertex coordinate '-inf' is not finite"},
    {"OverflowingVertex", "v 0 0 1e999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "",
     "scene.obj:1: vertex coordinate '1e999' is not finite"},
    {"VertexBeyondFloat", "v 0 0 0\nv 1 0 -1e19\nv 0 1 0\nf 1 2 3\n", "",
     "scene.obj:2: vertex coordinate '-1e19' is too large; at most 1e+18"},
    {"NanOfAnUnusedVertex", kHead + "f 1 2 3\nv nan 0 0\n", "", "scene.obj:5: vertex coordinate 'nan'"},
    {"VertexCutShort", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", "",
     "scene.obj:2: 'v 1 0' is cut short; a vertex needs three numbers"},
    {"VertexAlone", kHead + "f 1 2 3\nv", "", "scene.obj:5: 'v' is cut short"},
    {"VertexNoNumber", "v 0 0 0\nv 1 O 0\nv 0 1 0\nf 1 2 3\n", "",
     "scene.obj:2: 'O' is no number; a vertex needs three numbers, x y z"},
    {"VertexDecimalComma", "v 0 0 0\nv 1,5 0 0\nv 0 1 0\nf 1 2 3\n", "", "scene.obj:2: '1,5' is no number"},
    {"VertexNumberCut", "v 0 0 0\nv 1 0 1e\n", "", "scene.obj:2: '1e' is no number"},
    {"NormalNoNumber", kHead + "vn 0 0 up\nf 1 2 3\n", "",
     "scene.obj:4: 'up' is no number; a normal needs three numbers"},
    {"Empty", "", "", "scene.obj: no faces (0 vertices); give at least one 'f' line"},
    {"OnlyComments", "# nothing\n\n", "", "scene.obj: no faces"},
    {"NoFaces", kHead, "", "scene.obj: no faces (3 vertices)"},
    {"OnlyDegenerateFaces", kHead + "f 1 1 2\nf 2 2 2\n", "",
     "scene.obj: no faces with an area (all 2 triangles have none)"},
    {"Binary",
     std::string("\x7f"
                 "ELF\0\1\2\xff\xfe",
                 9),
     "", "scene.obj: no faces"},
};

const std::string kUse = "mtllib scene.mtl\nusemtl a\n" + kHead + "f 1 2 3\n";
const std::vector<BadText> kBadMtl{
    {"NegativeColour", kUse, "newmtl a\nillum 1\nKd .1 -.2 .3\n",
     "scene.mtl:3: Kd is negative (-.2); give 0 or above"},
    {"NegativeEmission", kUse, "newmtl a\nKe -1 0 0\n", "scene.mtl:2: Ke is negative"},
    {"NegativeUnusedColour", kUse, "newmtl a\nnewmtl b\nKa 0 0 -1\n", "scene.mtl:3: Ka is negative"},
    {"NanColour", kUse, "newmtl a\nKs nan 0 0\n",
     "scene.mtl:2: Ks is 'nan', which is not finite; give a number"},
    {"InfiniteColour", kUse, "newmtl a\r\nKe 1e999 0 0\r\n",
     "scene.mtl:2: Ke is '1e999', which is not finite"},
    {"ColourBeyondFloat", kUse, "newmtl a\nKe 1e30 0 0\n",
     "scene.mtl:2: Ke is 1e30, beyond the range of float"},
    {"ColourCutShort", kUse, "newmtl a\nKd .1 .2\n",
     "scene.mtl:2: 'Kd .1 .2' is cut short; Kd needs three numbers, r g b"},
    {"ColourNoNumber", kUse, "newmtl a\nKd .1 .2 red\n",
     "scene.mtl:2: 'red' is no number; Kd needs three numbers"},
    {"ColourSpectral", kUse, "newmtl a\nKd spectral a.rfl\n", "scene.mtl:2: "},
    {"NoName", kUse, "newmtl\nKd .1 .2 .3\n", "scene.mtl:1: newmtl without a name; give one"},
    {"IllumNoNumber", kUse, "newmtl a\nillum glass\n", "scene.mtl:2: 'illum glass' is no illumination model"},
    {"IllumHuge", kUse, "newmtl a\nillum 99999999999\n",
     "scene.mtl:2: 'illum 99999999999' is no illumination model"},
    {"GlassOfIndexZero", kUse, "newmtl a\nillum 4\nNi 0\n",
     "scene.mtl:3: material 'a': Ni 0 is no index of refraction"},
    {"GlassOfNegativeIndex", kUse, "newmtl a\nillum 4\nNi -1.5\n", "scene.mtl:3: material 'a': Ni -1.5"},
    {"ExponentNegative", kUse, "newmtl a\nKs 1 1 1\nNs -1\nillum 2\n",
     "scene.mtl:3: material 'a': Ns -1 is no exponent; give 0 to 1e+06"},
    {"ExponentHuge", kUse, "newmtl a\nKs 1 1 1\nNs 1000001\nillum 2\n",
     "scene.mtl:3: material 'a': Ns 1000001 is no exponent"},
    {"ExponentNoNumber", kUse, "newmtl a\nNs shiny\n",
     "scene.mtl:2: 'shiny' is no number; Ns needs a number"},
    {"IndexInfinite", kUse, "newmtl a\nNi inf\n", "scene.mtl:2: Ni is 'inf', which is not finite"},
};

const auto kName = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Obj, BadTextTest, testing::ValuesIn(kBadObj), kName);
INSTANTIATE_TEST_SUITE_P(Mtl, BadTextTest, testing::ValuesIn(kBadMtl), kName);

void expectError(const fs::path& file, const std::string& expected) {
  const std::string what = errorOf({file});
  EXPECT_NE(what.find(expected), std::string::npos) << "message: " << what;
}

TEST(BadFile, MissingNamesTheFileAndTheNearestScene) {
  expectError(
      "/nowhere/scene.obj",
      "/nowhere/scene.obj: no such file; a scene is an .obj file or a Nori .xml file, or one of the built-in "
      "cornell, cornell-spheres");
  expectError(
      "corNel",
      "corNel: no such file; a scene is an .obj file or a Nori .xml file, or one of the built-in cornell, "
      "cornell-spheres, did you mean 'cornell'?");
  expectError("cornell-sphere", "did you mean 'cornell-spheres'?");
  expectError("CornelBox.obj", "did you mean 'CornellBox.obj'?");
  expectError("", "no such file");
}

TEST(BadFile, Folder) {
  const TempFolder folder;
  expectError(folder.path(),
              folder.path().string() + ": is a folder; name an .obj file in it, or an .xml file");
}

TEST(BadFile, UnknownExtension) {
  const TempFolder folder;
  expectError(folder.write("scene.stl", "solid"),
              "scene.stl: unknown extension '.stl'; a scene is an .obj file or a Nori .xml file");
  expectError(folder.write("scene", "solid"), "scene: unknown extension ''");
  EXPECT_EQ(errorOf({folder.write("SCENE.OBJ", kSquare)}), "") << "extensions in any case";
}

TEST(BadFile, Unreadable) {
  // A regular file whose every read fails, for root too.
  if (!fs::exists("/proc/self/mem")) {
    GTEST_SKIP() << "no /proc";
  }
  const TempFolder folder;
  const fs::path file = folder.path() / "scene.obj";
  fs::create_symlink("/proc/self/mem", file);
  expectError(file, "scene.obj: cannot be read; check its permissions");
  EXPECT_NE(errorOf({folder.write("use.obj", "mtllib scene.obj\n")}), "") << "no faces, but no crash either";
}

TEST(BadFile, NoRegularFile) { expectError("/dev/null", "/dev/null: is no regular file"); }

TEST(BadFile, LongNames) {
  expectError(std::string(5000, 'a') + ".obj", ": cannot be read (File name too long)");
  expectError(std::string(250, 'a'), ": no such file");
}

TEST(BadFile, MessagesStayShortAndPrintable) {
  const std::string what = errorOfText("v 0 \x1b[31m" + std::string(100000, 'x') + " 0\n");
  EXPECT_LT(what.size(), 300U);
  EXPECT_EQ(what.find('\x1b'), std::string::npos);
}

TEST(BadFile, TheSecondOfSeveralIsNamed) {
  const TempFolder folder;
  const fs::path good = folder.write("good.obj", kSquare);
  const fs::path bad = folder.write("bad.obj", "v 0 0 0\nf 1 1 2\n");
  const std::string what = errorOf({good, bad});
  EXPECT_NE(what.find("bad.obj:2: vertex index 2"), std::string::npos) << what;
}

TEST(BadFile, EveryCutOfAFileIsAnErrorOrAScene) {
  const std::string whole =
      "mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nusemtl a\nf 1//1 2//1 -1//-1\n";
  const std::string mtl = "newmtl a\nKd .1 .2 .3\nKa 2 2 2\nillum 4\nNi 1.5\nmap_Kd -o 1 2 3 a.png\n";
  for (std::size_t end = 0; end <= whole.size(); ++end) {
    errorOfText(whole.substr(0, end), mtl);
  }
  for (std::size_t end = 0; end <= mtl.size(); ++end) {
    errorOfText(whole, mtl.substr(0, end));
  }
}

TEST(BadFile, EveryChangedByteIsAnErrorOrAScene) {
  const std::string obj =
      "mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nusemtl a\nf 1//1 2//1 -1//-1\n";
  const std::string mtl = "newmtl a\nKd .1 .2 .3\nillum 11\n";
  for (std::size_t i = 0; i < obj.size(); ++i) {
    for (const char c : {'\0', '\n', '\r', '/', '-', '9', '#', '\\', 'e', '\xff'}) {
      std::string changed = obj;
      changed[i] = c;
      errorOfText(changed, mtl);
    }
  }
}

} // namespace
} // namespace vkpt::test
