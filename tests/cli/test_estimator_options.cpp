// The options that the assignments ask for, as a user meets them.

#include "cli/command.h"
#include "film/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vkpt::test {
namespace {

constexpr std::array<const char*, 6> kKinds{"emission", "direct",           "caustic",
                                            "indirect", "indirect-caustic", "specular"};

double largestDifference(const Image& a, const Image& b) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t i = 0; i < a.pixelCount(); ++i)
      largest =
          std::max(largest, std::abs(static_cast<double>(a.channels[c].values[i]) - b.channels[c].values[i]));
  }
  return largest;
}

nlohmann::json statsOf(const WorkFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--stats", "s.json"});
  const CommandResult r = vkpt(arguments, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 0) << r.err;
  return folder.json("s.json");
}

TEST(LightPaths, ImagesOfTheKindsAddUpToTheWhole) {
  const WorkFolder folder;
  const CommandResult r = vkpt({"cornell-spheres", "--size", "40x40", "--frames", "70", "--output-paths",
                                "kind", "-o", "whole.exr", "-o", "whole.pfm"},
                               {folder.path(), {}});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  const Image whole = readImage(folder / "whole.exr");
  Image sum(whole.width, whole.height, {"R", "G", "B"});
  for (const char* kind : kKinds) {
    const Image single = readImage(folder / (std::string("kind-") + kind + ".pfm"));
    double brightest = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const Image::Channel* layer = whole.find(std::string(kind) + "." + "RGB"[c]);
      ASSERT_NE(layer, nullptr) << kind;
      EXPECT_EQ(layer->values, single.channels[c].values) << kind;
      for (std::size_t i = 0; i < whole.pixelCount(); ++i) {
        sum.channels[c].values[i] += single.channels[c].values[i];
        brightest = std::max(brightest, static_cast<double>(single.channels[c].values[i]));
      }
    }
    EXPECT_GT(brightest, 0.0) << kind << " is all black";
  }
  EXPECT_LT(largestDifference(sum, whole), 2e-5 * 36.8); // of the lamp's radiance: rounding of float sums
}

TEST(LightPaths, OneKindIsTheSameAloneAndAmongAll) {
  const WorkFolder folder;
  const std::vector<std::string> common{"cornell-spheres", "--size", "24x24", "--frames", "64"};
  auto all = common;
  all.insert(all.end(), {"--output-paths", "kind", "-o", "whole.pfm"});
  ASSERT_EQ(vkpt(all, {folder.path(), {}}).exitCode, 0);
  for (const char* kind : {"direct", "specular"}) { // nothing of them is pruned, so the numbers are the same
    auto one = common;
    one.insert(one.end(), {"--paths", kind, "-o", "one.pfm"});
    ASSERT_EQ(vkpt(one, {folder.path(), {}}).exitCode, 0);
    EXPECT_LT(largestDifference(readImage(folder / "one.pfm"),
                                readImage(folder / (std::string("kind-") + kind + ".pfm"))),
              1e-4)
        << kind;
  }
}

TEST(LightPaths, LeavingSomeOutIsRecordedAsBias) {
  const WorkFolder folder;
  const auto stats = statsOf(folder, {"--size", "8x8", "--frames", "2", "--paths", "caustic,indirect"});
  EXPECT_EQ(stats["bias"], nlohmann::json::array({"--paths caustic,indirect"}));
}

TEST(Termination, WithProbabilityOneIsALimitOnBounces) {
  const WorkFolder folder;
  const auto one =
      statsOf(folder, {"cornell", "--size", "24x24", "--frames", "8", "--roulette", "constant=1"});
  EXPECT_EQ(one["bias"], nlohmann::json::array({"--roulette constant=1 (--max-bounces 2)"}));
  const auto limit = statsOf(folder, {"cornell", "--size", "24x24", "--frames", "8", "--max-bounces", "2"});
  EXPECT_EQ(one["mean"], limit["mean"]);
  const auto some =
      statsOf(folder, {"cornell", "--size", "24x24", "--frames", "8", "--roulette", "constant=0.1"});
  EXPECT_TRUE(some["bias"].empty());
  EXPECT_GT(some["mean"][0], 1.1 * one["mean"][0].get<double>());
}

TEST(Tail, AnInfiniteVarianceIsSaid) {
  const WorkFolder folder;
  const CommandResult r = vkpt(
      {"cornell", "--size", "96x96", "--frames", "96", "--roulette", "constant=0.7", "--stats", "s.json"},
      {folder.path(), {}});
  EXPECT_NE(r.out.find("the standard error is not to be trusted"), std::string::npos) << r.out;
  EXPECT_FALSE(folder.json("s.json")["error"]["trusted"]);
  const auto calm = statsOf(folder, {"cornell", "--size", "96x96", "--frames", "96"});
  EXPECT_TRUE(calm["error"]["trusted"]);
}

TEST(Sampler, SobolUnlessSaidOtherwiseAndTellsItsError) {
  const WorkFolder folder;
  const auto sobol = statsOf(folder, {"cornell", "--size", "64x64", "--frames", "128", "--paths", "direct"});
  const auto independent = statsOf(folder, {"cornell", "--size", "64x64", "--frames", "128", "--paths",
                                            "direct", "--sampler", "independent"});
  EXPECT_EQ(sobol["sampler"], "sobol");
  EXPECT_EQ(independent["sampler"], "independent");
  // Direct light alone has few dimensions.
  EXPECT_LT(sobol["error"]["relative"].get<double>(), 0.75 * independent["error"]["relative"].get<double>());
  const double difference = sobol["mean"][1].get<double>() - independent["mean"][1].get<double>();
  EXPECT_LT(std::abs(difference), 5.0 * std::hypot(sobol["error"]["standardError"][1].get<double>(),
                                                   independent["error"]["standardError"][1].get<double>()));
}

TEST(NoriFile, SaysWhatHoldsAndOptionsComeFirst) {
  const WorkFolder folder;
  folder.write("square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
  folder.write("scene.xml", R"(<scene>
  <integrator type="direct_mats"/>
  <sampler type="independent"><integer name="sampleCount" value="3"/></sampler>
  <camera type="perspective">
    <transform name="toWorld"><scale value="-1,1,1"/><lookat origin="0,0,4" target="0,0,0" up="0,1,0"/></transform>
    <integer name="width" value="20"/><integer name="height" value="10"/>
    <rfilter type="tent"/>
  </camera>
  <mesh type="obj"><string name="filename" value="square.obj"/>
    <bsdf type="diffuse"><color name="kd" value="1,0,0"/></bsdf>
    <emitter type="area"><color name="radiance" value="1,2,3"/></emitter>
  </mesh>
</scene>)");
  const CommandResult r = vkpt({"scene.xml", "--verbose", "--stats", "s.json"}, {folder.path(), {}});
  ASSERT_EQ(r.exitCode, 0) << r.err;
  for (const char* expanded : {"--frames 3", "--size 20x10", "--light bsdf --max-bounces 1", "--filter tent"})
    EXPECT_NE(r.err.find(expanded), std::string::npos) << expanded << " is not in\n" << r.err;
  EXPECT_EQ(r.warnings().size(), 1U) << r.err; // kd on a diffuse
  EXPECT_NE(r.out.find("Nori conventions"), std::string::npos) << r.out;
  EXPECT_EQ(vkpt({"scene.xml", "--strict"}, {folder.path(), {}}).exitCode, 2);
  const CommandResult options =
      vkpt({"scene.xml", "--verbose", "--light", "mis", "--filter", "box", "--max-bounces", "inf"},
           {folder.path(), {}});
  for (const char* expanded : {"--light mis --max-bounces inf", "--filter box"})
    EXPECT_NE(options.err.find(expanded), std::string::npos) << expanded << " is not in\n" << options.err;
}

/// By default where there are caustics; an error only where it was asked for.
TEST(LightTracing, IsThereWhereItCanBe) {
  const WorkFolder folder;
  const std::vector<std::string> common{"--size", "16x16", "--frames", "4"};
  const auto traces = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), common.begin(), common.end());
    const auto effects = statsOf(folder, arguments)["effects"];
    return std::ranges::find(effects, "lightTracing") != effects.end();
  };
  EXPECT_TRUE(traces({"cornell-spheres"}));
  EXPECT_TRUE(traces({"cornell-spheres", "--light-tracing", "on"}));
  EXPECT_FALSE(traces({"cornell-spheres", "--light-tracing", "off"}));
  EXPECT_FALSE(traces({"cornell"}));
  EXPECT_FALSE(traces({"cornell", "--light-tracing", "on"})) << "no caustics, no error";
  EXPECT_FALSE(traces({"cornell-spheres", "--split", "2"}));
  EXPECT_FALSE(traces({"cornell-spheres", "--output-paths", "kind"}));
  const CommandResult r = vkpt(
      {"cornell-spheres", "--light-tracing", "on", "--split", "2", "-o", "refused.png"}, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 1);
  EXPECT_NE(r.err.find("--light-tracing on can't go together with --split 2"), std::string::npos) << r.err;
  EXPECT_FALSE(fs::exists(folder / "refused.png"));
}

/// With paths from the lights, and where an image may have what it is for.
TEST(Guiding, GoesWithLightTracing) {
  const WorkFolder folder;
  const auto guides = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--size", "16x16", "--frames", "4"});
    const auto effects = statsOf(folder, arguments)["effects"];
    return std::ranges::find(effects, "guiding") != effects.end();
  };
  EXPECT_TRUE(guides({"cornell-spheres"}));
  EXPECT_TRUE(guides({"cornell-spheres", "--max-bounces", "3"}));
  EXPECT_FALSE(guides({"cornell-spheres", "--max-bounces", "2"}));
  EXPECT_FALSE(guides({"cornell-spheres", "--guiding", "off"}));
  EXPECT_FALSE(guides({"cornell-spheres", "--light-tracing", "off"}));
  EXPECT_FALSE(guides({"cornell"}));
  const CommandResult r =
      vkpt({"cornell-spheres", "--guiding", "always", "-o", "refused.png"}, {folder.path(), {}});
  EXPECT_EQ(r.exitCode, 1);
  EXPECT_NE(r.err.find("--guiding"), std::string::npos) << r.err;
  EXPECT_FALSE(fs::exists(folder / "refused.png"));
}

TEST(PathReuse, IsRefusedWhereItCannotBe) {
  const WorkFolder folder;
  const auto refused = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"cornell", "-o", "refused.png"});
    const CommandResult r = vkpt(options, {folder.path(), {}});
    EXPECT_EQ(r.exitCode, 1);
    EXPECT_FALSE(fs::exists(folder / "refused.png"));
    return r.err;
  };
  EXPECT_NE(
      refused({"--path-reuse", "4", "--split", "2"}).find("--path-reuse 4 can't go together with --split 2"),
      std::string::npos);
  EXPECT_NE(refused({"--path-reuse", "4", "--output-paths", "kind"}).find("--output-paths"),
            std::string::npos);
  EXPECT_NE(refused({"--path-reuse", "5"}).find("1, 4, 16 or 64 pixels"), std::string::npos);
}

/// By default where lights are spread out: not for the two triangles of a lamp.
TEST(LightSelection, IsByTheTreeWhereItIsAskedFor) {
  const WorkFolder folder;
  const auto byTree = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--size", "16x16", "--frames", "4"});
    const auto effects = statsOf(folder, arguments)["effects"];
    return std::ranges::find(effects, "lightTree") != effects.end();
  };
  EXPECT_FALSE(byTree({"cornell"}));
  EXPECT_FALSE(byTree({"cornell", "--light-selection", "power"}));
  EXPECT_TRUE(byTree({"cornell", "--light-selection", "tree"}));
}

TEST(Environment, LightsTheSceneAndIsSeen) {
  const WorkFolder folder;
  folder.write("far.obj", "v 100 0 0\nv 101 0 0\nv 100 1 0\nf 1 2 3\n");
  std::string sky = "PF\n2 1\n-1.0\n";
  const std::array<float, 6> pixels{0.5F, 1.0F, 2.0F, 0.5F, 1.0F, 2.0F};
  sky.append(reinterpret_cast<const char*>(pixels.data()), sizeof pixels);
  folder.write("sky.pfm", sky);
  const auto stats = statsOf(folder, {"far.obj", "--environment", "sky.pfm", "--look-at", "0,0,0,-1,0,0",
                                      "--size", "8x8", "--frames", "4"});
  EXPECT_EQ(stats["mean"], nlohmann::json::array({0.5, 1.0, 2.0}));
  EXPECT_EQ(vkpt({"far.obj", "--environment", "nowhere.pfm"}, {folder.path(), {}}).exitCode, 2);
  EXPECT_EQ(vkpt({"far.obj", "--environment", "sky.jpg"}, {folder.path(), {}}).exitCode, 1);
}

} // namespace
} // namespace vkpt::test
