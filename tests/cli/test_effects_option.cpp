// --effects and explain, as a user meets them.

#include "cli/command.h"
#include "cli/small_scenes.h"
#include "film/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vkpt::test {
namespace {

using Arguments = std::vector<std::string>;

Arguments joined(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const Image::Channel& channel(const Image& image, const std::string& prefix, std::size_t c) {
  return *image.find(prefix + "RGB"[c]);
}

/// Of the same seed: 99.9 % of the pixels are equal within 1e-4 (relative, and of a white's radiance), and of
/// the rest, where one branch went another way, none lies further off than its standard errors allow.
void expectSameImage(const Image& a, const Image& b) {
  ASSERT_EQ(a.pixelCount(), b.pixelCount());
  std::size_t apart = 0;
  double worst = 0.0;
  for (std::size_t i = 0; i < a.pixelCount(); ++i) {
    bool equal = true;
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = channel(a, "", c).values[i];
      const double y = channel(b, "", c).values[i];
      if (std::abs(x - y) <= 1e-4 * std::max(1.0, std::abs(y)))
        continue;
      equal = false;
      const double sx = channel(a, "stderr.", c).values[i];
      const double sy = channel(b, "stderr.", c).values[i];
      worst = std::max(worst, std::abs(x - y) / std::hypot(sx, sy));
    }
    apart += equal ? 0U : 1U;
  }
  tell("pixels that differ", static_cast<double>(apart) / static_cast<double>(a.pixelCount()) * 100.0, "%");
  EXPECT_LE(static_cast<double>(apart), 1e-3 * static_cast<double>(a.pixelCount()));
  EXPECT_LT(worst, 4.0) << "standard errors; the samples but one are the same, so it is about 1 at most";
}

struct SceneCase {
  const char* test;
  Arguments arguments;
};

/// A textured floor, a glossy block, a mirror and glass under a sky.
void writeStillLife(const WorkFolder& folder) {
  Image checks(8, 8, {"R", "G", "B"});
  for (auto& values : checks.channels) {
    for (std::size_t i = 0; i < 64; ++i)
      values.values[i] = (i + i / 8) % 2 == 0 ? 0.8F : 0.2F;
  }
  writeImage(folder / "checks.hdr", checks, {}, {});
  Image sky(8, 4, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < 32; ++i)
      sky.channels[c].values[i] = i == 11 ? 6.0F : 0.2F + 0.1F * static_cast<float>(c);
  }
  writeImage(folder / "sky.pfm", sky, {}, {});
  folder.write("life.mtl", "newmtl floor\nillum 1\nKd 1 1 1\nmap_Kd checks.hdr\n"
                           "newmtl block\nillum 2\nKd .3 .2 .1\nKs .4 .4 .4\nNs 40\n"
                           "newmtl glass\nillum 4\nNi 1.5\n"
                           "newmtl mirror\nillum 3\n"
                           "newmtl air\nillum 4\nNi 1\n");
  folder.write("life.obj", "mtllib life.mtl\n"
                           "v -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\n"
                           "v -1 0 -1\nv 0 0 -1\nv 0 1 -1\nv -1 1 -1\n"
                           "v .2 0 .5\nv .9 0 .2\nv .9 .7 .2\nv .2 .7 .5\n"
                           "v .3 0 -1\nv 1.5 0 -.6\nv 1.5 1 -.6\nv .3 1 -1\n"
                           "vt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\nvn 0 1 0\nvn 0 0 1\nvn .1 0 .99\n"
                           "usemtl floor\nf 4/1/1 3/2/1 2/3/1 1/4/1\n"
                           "usemtl block\nf 5//2 6//3 7//3 8//2\n"
                           "usemtl glass\nf 9//2 10//2 11//2 12//2\n"
                           "usemtl mirror\nf 13//2 14//2 15//2 16//2\n"
                           "usemtl air\nf 9//2 6//2 7//2 12//2\n");
}

class EffectsAll : public testing::TestWithParam<SceneCase> {};

TEST_P(EffectsAll, GiveTheSameImage) {
  const WorkFolder folder;
  writeStillLife(folder);
  const Arguments common = joined(GetParam().arguments, {"--size", "80x80", "--frames", "16", "--quiet"});
  const CommandResult own =
      vkpt(joined(common, {"-o", "own.exr", "--stats", "own.json"}), {folder.path(), {}});
  ASSERT_EQ(own.exitCode, 0) << own.err;
  const CommandResult all =
      vkpt(joined(common, {"-o", "all.exr", "--stats", "all.json", "--effects", "all"}), {folder.path(), {}});
  ASSERT_EQ(all.exitCode, 0) << all.err;
  expectSameImage(readImage(folder / "own.exr"), readImage(folder / "all.exr"));
  const auto stats = folder.json("all.json");
  EXPECT_GT(stats["effects"].size(), folder.json("own.json")["effects"].size());
  EXPECT_EQ(stats["bias"], folder.json("own.json")["bias"]) << "everything is no bias";
  EXPECT_EQ(readImage(folder / "all.exr").find("caustic.R"), nullptr) << "layers that nobody asked for";
}

INSTANTIATE_TEST_SUITE_P(
    Of, EffectsAll,
    testing::Values(SceneCase{"TheBlocks", {"cornell"}}, SceneCase{"TheSpheres", {"cornell-spheres"}},
                    SceneCase{"TheNoriBox", {VKPT_SOURCE_DIR "/assets/cbox.xml"}},
                    SceneCase{"TheNoriMeshes", {VKPT_SOURCE_DIR "/assets/cbox-meshes.xml"}},
                    SceneCase{"TheBusts", {VKPT_SOURCE_DIR "/assets/busts.xml"}},
                    SceneCase{"TheChambers", {VKPT_SOURCE_DIR "/assets/q-scene.xml"}},
                    SceneCase{"AStillLife",
                              {"life.obj", "--environment", "sky.pfm", "--look-at", "0,1.2,3,0,.4,0"}},
                    SceneCase{"AStillLifeByNee",
                              {"life.obj", "--environment", "sky.pfm", "--look-at", "0,1.2,3,0,.4,0",
                               "--light", "nee", "--max-bounces", "4"}},
                    SceneCase{"EmissionAlone", {"cornell-spheres", "--max-bounces", "0"}},
                    SceneCase{"OneKind", {"cornell-spheres", "--paths", "caustic", "--split", "2"}}),
    [](const auto& test) { return std::string(test.param.test); });

TEST(EffectsLeftOut, AreRecordedAsBias) {
  const WorkFolder folder;
  const CommandResult r = vkpt({"cornell-spheres", "--size", "16x16", "--frames", "2", "--stats", "s.json",
                                "--effects", "auto,-glass,-smoothNormals"},
                               {folder.path(), {}});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  EXPECT_NE(r.out.find("biased by: --effects auto,-glass,-smoothNormals"), std::string::npos) << r.out;
  const auto stats = folder.json("s.json");
  EXPECT_EQ(stats["bias"], nlohmann::json::array({"--effects auto,-glass,-smoothNormals"}));
  const auto names = stats["effects"].get<Arguments>();
  EXPECT_EQ(std::ranges::count(names, "glass"), 0);
  EXPECT_EQ(std::ranges::count(names, "metal"), 1);
}

TEST(EffectsLeftOut, ThatWereNotOnAreAWarning) {
  const WorkFolder folder;
  const Arguments arguments{"cornell", "--size", "8x8",       "--frames",   "1",
                            "--stats", "s.json", "--effects", "auto,-phong"};
  const CommandResult r = vkpt(arguments, {folder.path(), {}});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  ASSERT_EQ(r.warnings().size(), 1U) << r.err;
  EXPECT_NE(r.warnings()[0].find("the scene does not call for it"), std::string::npos);
  EXPECT_TRUE(folder.json("s.json")["bias"].empty());
  EXPECT_EQ(vkpt(joined(arguments, {"--strict"}), {folder.path(), {}}).exitCode, 2);
}

TEST(EffectsLeftOut, HaveToBeNamed) {
  const WorkFolder folder;
  const auto errorOf = [&](const std::string& value) {
    const CommandResult r = vkpt({"--effects", value}, {folder.path(), {}});
    EXPECT_EQ(r.exitCode, 1) << value;
    EXPECT_EQ(r.errors().size(), 1U) << r.err;
    return r.errors().empty() ? std::string() : r.errors().front();
  };
  EXPECT_NE(errorOf("auto,-glas").find("did you mean 'glass'?"), std::string::npos);
  EXPECT_NE(errorOf("auto,-caustics").find("there are diffuse, mirror"), std::string::npos);
  for (const char* wrong : {"none", "auto,glass", "all,-glass", "auto,", "-glass", ""})
    EXPECT_NE(errorOf(wrong).find("expected auto, all or auto,-NAME"), std::string::npos) << wrong;
  EXPECT_NE(vkpt({"--measure"}, {folder.path(), {}}).err.find("for vkpt explain alone"), std::string::npos);
}

TEST(Explain, TellsEveryEffectAndTheMemory) {
  const WorkFolder folder;
  const CommandResult r = vkpt({"explain", "cornell-spheres", "--json", "--quiet"}, {folder.path(), {}});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const auto j = nlohmann::json::parse(r.out);
  const auto& effects = j["effects"];
  const auto named = [&](const std::string& name) {
    return *std::ranges::find_if(effects, [&](const auto& e) { return e["name"] == name; });
  };
  EXPECT_TRUE(named("glass")["on"]);
  EXPECT_EQ(named("glass")["because"], "material 'glass'");
  EXPECT_NE(named("glass")["file"].get<std::string>().find("CornellRightSphere.mtl"), std::string::npos);
  EXPECT_EQ(named("glass")["line"], 3);
  EXPECT_FALSE(named("phong")["on"]);
  EXPECT_TRUE(named("phong")["cost"].is_null());
  EXPECT_EQ(named("smoothNormals")["bytes"], j["triangles"].get<int>() * 48);
  std::uint64_t sum = 0;
  for (const auto& row : j["memory"])
    sum += row["bytes"].get<std::uint64_t>();
  EXPECT_EQ(j["bytes"], sum);
  EXPECT_TRUE(j["fits"]);
  const CommandResult text = vkpt({"explain", "cornell-spheres"}, {folder.path(), {}});
  EXPECT_NE(text.out.find("CornellRightSphere.mtl:3"), std::string::npos) << text.out;
  EXPECT_TRUE(folder.names().empty()) << "it writes no image";
}

TEST(Explain, PlansTheMemoryThatARenderTakes) {
  const WorkFolder folder;
  for (const char* effects : {"auto", "all"}) {
    const Arguments common{"cornell-spheres", "--size", "40x30", "--effects", effects};
    ASSERT_EQ(vkpt(joined(common, {"--frames", "1", "--stats", "s.json"}), {folder.path(), {}}).exitCode, 0);
    const CommandResult r = vkpt(joined({"explain", "--json"}, common), {folder.path(), {}});
    const auto plan = nlohmann::json::parse(r.out);
    std::uint64_t sum = 0;
    for (const auto& row : plan["memory"]) {
      if (!row["what"].get<std::string>().ends_with("at most")) // the statistics leave the path states out
        sum += row["bytes"].get<std::uint64_t>();
    }
    EXPECT_EQ(sum, folder.json("s.json")["deviceBytes"]) << effects;
  }
}

TEST(Explain, SaysWhatWasLeftOutAsNothing) {
  const WorkFolder folder;
  writeStillLife(folder);
  const CommandResult r = vkpt({"explain", "life.obj", "--environment", "sky.pfm"}, {folder.path(), {}});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  EXPECT_NE(r.out.find("2 triangles left out"), std::string::npos) << r.out;
}

TEST(Explain, SaysWhatDoesNotFit) {
  const WorkFolder folder;
  const CommandResult r = vkpt({"explain", "--json", "--size", "20000x20000"}, {folder.path(), {}});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  EXPECT_FALSE(nlohmann::json::parse(r.out)["fits"]);
}

} // namespace
} // namespace vkpt::test
