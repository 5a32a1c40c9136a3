// The effects of every scene that comes with the program.
#include "device/effects.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vkpt::test {
namespace {

using Names = std::vector<std::string>;

struct AssetCase {
  const char* name; ///< built in, or a file in assets/
  const char* test;
  Names effects; ///< by default options, the scene's own included
};

/// What every scene with several area lights and paths of any length has.
Names withCommon(Names names) {
  const Names common{"areaLights", "manyLights", "lightSampling", "roulette", "mis"};
  names.insert(names.end(), common.begin(), common.end());
  std::ranges::sort(names);
  return names;
}

const std::vector<AssetCase>& assetCases() {
  static const std::vector<AssetCase> cases{
      {"cornell", "Blocks", withCommon({"diffuse"})},
      {"cornell-spheres", "Spheres", withCommon({"diffuse", "glass", "metal", "smoothNormals"})},
      {"cbox.xml", "Cbox", withCommon({"diffuse", "oneSided", "pixelFilter"})},
      {"cbox-meshes.xml", "CboxMeshes",
       withCommon({"diffuse", "oneSided", "phong", "pixelFilter", "smoothNormals"})},
      {"busts.xml", "Busts", withCommon({"diffuse", "oneSided", "phong", "pixelFilter", "smoothNormals"})},
      {"q-scene.xml", "QScene",
       withCommon({"diffuse", "mirror", "oneSided", "phong", "pixelFilter", "smoothNormals"})},
  };
  return cases;
}

class AssetEffects : public testing::TestWithParam<std::size_t> {};

TEST_P(AssetEffects, AreThoseThatAreExpected) {
  const AssetCase& asset = assetCases()[GetParam()];
  fs::path path(asset.name);
  if (path.has_extension())
    path = fs::path(VKPT_SOURCE_DIR) / "assets" / path;
  SceneReport report;
  const Scene scene = loadScene({&path, 1}, report);
  Names names = detectEffects(scene, {}).names();
  std::ranges::sort(names);
  EXPECT_EQ(names, asset.effects);
}

INSTANTIATE_TEST_SUITE_P(Of, AssetEffects, testing::Range(std::size_t{0}, assetCases().size()),
                         [](const auto& test) { return std::string(assetCases()[test.param].test); });

} // namespace
} // namespace vkpt::test
