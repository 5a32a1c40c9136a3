// The tables by which lights are chosen: what is drawn is what they say, every light can be, and they know
// which ones matter where.
#include "device/light_grid.h"

#include "device/alias_bins.h"
#include "device/packed_light_node.h"
#include "scenes/made_scenes.h"
#include "shared/structs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace vkpt::test {
namespace {

using namespace shared;

TEST(AliasBins, DrawTheSharesThatTheyTell) {
  std::mt19937 engine(0xA11A5U);
  std::exponential_distribution<double> weight(1.0);
  for (const std::uint32_t bits : {1U, 4U, 8U, 10U, 15U}) {
    const std::uint32_t bins = 1U << bits;
    std::vector<double> weights(bins);
    for (double& w : weights)
      w = weight(engine);
    weights[0] = 0.0;
    std::vector<std::uint32_t> numbers;
    appendAliasBins(weights, numbers);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<std::uint32_t> drawn(bins);
    for (std::uint32_t row = 0; row < bins; ++row)
      for (std::uint32_t u = 0; u < kAliasUnits / bins; ++u)
        ++drawn[u < ((numbers[row] >> 16U) & ((kAliasUnits >> bits) - 1U)) ? row
                                                                           : numbers[row] >> (32U - bits)];
    for (std::uint32_t i = 0; i < bins; ++i) {
      ASSERT_EQ(drawn[i], numbers[i] & 65535U) << i << " of " << bins;
      ASSERT_NEAR(drawn[i], weights[i] / sum * kAliasUnits, 1.0) << i << " of " << bins;
    }
  }
}

/// A stand-in for the shader library's: the inverse square of the distance, the cosine at the surface.
std::function<LightGridFunctions()> functionsFor(const PackedScene& scene) {
  return [&scene] {
    return LightGridFunctions{[&scene](std::uint32_t node, const Vec3f& p, const Vec3f& n) {
                                const Vec3f d = Vec3f(lightNodeOf(scene, node).centre) - p;
                                const float cosine =
                                    n == Vec3f(0.0F) ? 1.0F : std::max(glm::dot(n, glm::normalize(d)), 1e-3F);
                                return cosine / std::max(glm::dot(d, d), 1e-3F);
                              },
                              [](const Vec3f& n) {
                                const Vec3f a = glm::abs(n);
                                const int axis = a.x >= a.y && a.x >= a.z ? 0 : (a.y >= a.z ? 1 : 2);
                                return static_cast<std::uint32_t>(2 * axis + (n[axis] < 0.0F ? 1 : 0));
                              }};
  };
}

PackedScene packed(const Scene& scene) {
  EstimatorSettings settings;
  settings.lightSelection = LightSelection::Tree;
  return packScene(scene, settings, 1);
}

PackedScene gridOf(const Scene& scene, unsigned threads = 1) {
  PackedScene p = packed(scene);
  makeLightGrid(p, scene, functionsFor(p), threads);
  return p;
}

std::uint32_t startOf(const PackedScene& scene, const Vec3f& p, std::uint32_t side) {
  const CubeGrid& grid = scene.lightChoice.grid;
  const Vec3f q = (p - grid.lower) * grid.cubesPerMetre;
  const auto cube = [&](int axis) { return static_cast<std::uint32_t>(q[axis]); };
  return scene.lightGrid.at(guideCube(cube(0), cube(1), cube(2), kLightGridEdge) * kLightGridSides + side);
}

std::uint32_t unitsOf(const PackedScene& scene, std::uint32_t start, std::uint32_t light) {
  return scene.lightGrid.at(start + light) & 65535U;
}

/// A floor between a row of lamps above it and one below; lamp 2 i is the i-th above.
Scene lampsOnBothSides(int count = 8) {
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 4.0, diffuse(Vec3f(0.5F)));
  const double step = 8.0 / count;
  for (int i = 0; i < count; ++i)
    for (const double y : {3.0, -3.0}) {
      const Vec3d at(step * i - 4.0, y, 0.0);
      builder.triangle(at, at + Vec3d(0.2 * step, 0.0, 0.0), at + Vec3d(0.0, 0.0, 0.2), emitter(Vec3f(1.0F)));
    }
  return builder.build();
}

constexpr std::uint32_t kUp = 2;
constexpr std::uint32_t kDown = 3;

TEST(LightGrid, IsNothingUntilItHasLearned) {
  const PackedScene p = packed(lampsOnBothSides());
  EXPECT_TRUE(p.lightChoice.byTree);
  EXPECT_FALSE(p.lightChoice.byTables);
  EXPECT_TRUE(p.lightChoice.belowTables);
  EXPECT_EQ(p.lightGrid.size(), 4U) << "a dummy";
}

TEST(LightGrid, ChoosesByPowerOutsideOfItsCubes) {
  const PackedScene p = gridOf(lampsOnBothSides());
  ASSERT_TRUE(p.lightChoice.byTables);
  EXPECT_FALSE(p.lightChoice.belowTables);
  EXPECT_EQ(p.lightChoice.tableBits, 4U);
  for (std::uint32_t side = 0; side < kLightGridSides; ++side)
    for (std::uint32_t light = 0; light < 16; ++light)
      EXPECT_EQ(unitsOf(p, p.lightGrid[kLightGridCubes * kLightGridSides + side], light), kAliasUnits / 16);
}

TEST(LightGrid, KnowsWhatIsNearAndOnWhichSide) {
  const PackedScene p = gridOf(lampsOnBothSides());
  const std::uint32_t above = startOf(p, Vec3f(-3.9F, 0.0F, 0.1F), kUp);
  const std::uint32_t below = startOf(p, Vec3f(-3.9F, 0.0F, 0.1F), kDown);
  const std::uint32_t far = startOf(p, Vec3f(3.1F, 0.0F, 0.1F), kUp);
  EXPECT_GT(unitsOf(p, above, 0), 4 * unitsOf(p, above, 14)) << "near and far";
  EXPECT_GT(unitsOf(p, far, 14), 4 * unitsOf(p, far, 0)) << "the other end";
  EXPECT_GT(unitsOf(p, above, 0), 100 * unitsOf(p, above, 1)) << "before and behind";
  EXPECT_GT(unitsOf(p, below, 1), 100 * unitsOf(p, below, 0)) << "the other side";
  const std::uint32_t any = startOf(p, Vec3f(-3.9F, 0.0F, 0.1F), kAnySide);
  EXPECT_GT(unitsOf(p, any, 1), 10 * unitsOf(p, above, 1)) << "both sides";
  EXPECT_EQ(startOf(p, Vec3f(-3.9F, 0.0F, 0.1F), 0), any) << "a side that no surface shows";
}

/// In every table; and none is drawn that there is not.
TEST(LightGrid, LeavesNoLightOut) {
  for (const int count : {8, 11, 513}) {
    const PackedScene p = gridOf(lampsOnBothSides(count));
    const std::uint32_t bins = 1U << p.lightChoice.tableBits;
    const std::uint32_t nodes = std::min(2U * static_cast<std::uint32_t>(count), 1U << kMostLightTableBits);
    EXPECT_EQ(p.lightChoice.belowTables, count == 513);
    const std::size_t tables = (kLightGridCubes + 1) * kLightGridSides + bins;
    EXPECT_GT(p.lightGrid.size(), tables + 3 * bins);
    for (std::size_t start = tables; start < p.lightGrid.size(); start += bins)
      for (std::uint32_t bin = 0; bin < bins; ++bin)
        ASSERT_EQ(unitsOf(p, static_cast<std::uint32_t>(start), bin) > 0, bin < nodes)
            << bin << " of " << count;
  }
}

/// Lamps as close to the floor as a hundredth of a cube, as far from each other as a third: what a cube's
/// table knows is wrong nearly everywhere in it.
TEST(LightGrid, LeavesItToTheTreeWhereItsCubesAreTooLarge) {
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 4.0, diffuse(Vec3f(0.5F)));
  for (int i = 0; i < 400; ++i)
    builder.ceiling({-4.0 + 0.4 * (i % 20), 0.01, -4.0 + 0.4 * (i / 20)}, 0.005, emitter(Vec3f(1.0F)));
  const Scene scene = builder.build();
  const PackedScene before = packed(scene);
  const PackedScene p = gridOf(scene);
  EXPECT_FALSE(p.lightChoice.byTables);
  EXPECT_EQ(p.lightGrid.size(), 4U);
  EXPECT_EQ(p.triangles, before.triangles) << "lights are numbered by their leaves";
  EXPECT_EQ(p.lightNodes, before.lightNodes) << "no node has a bin";
  EXPECT_EQ(p.lightChoice.tableBits, before.lightChoice.tableBits);
}

TEST(LightGrid, DoesNotDependOnThreads) {
  const Scene scene = lampsOnBothSides();
  EXPECT_EQ(gridOf(scene, 1).lightGrid, gridOf(scene, 3).lightGrid);
}

/// Where the tree was not asked for.
TEST(LightGrid, IsLeftOutWithoutTheTree) {
  const Scene scene = lampsOnBothSides();
  EstimatorSettings settings;
  settings.lightSelection = LightSelection::Power;
  PackedScene p = packScene(scene, settings, 1);
  makeLightGrid(p, scene, functionsFor(p), 1);
  EXPECT_EQ(p.lightGrid.size(), 4U);
  EXPECT_EQ(p.lightChoice.grid.edge, 0U);
}

} // namespace
} // namespace vkpt::test
