// The tree over the lights: nothing is lost in it, and its bounds hold.
#include "device/light_tree.h"
#include "scenes/made_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vkpt::test {
namespace {

struct Built {
  Scene scene;
  LightTable table;
  LightTree tree;
};

Built treeOf(const Scene& scene) {
  const LightTable table = makeLightTable(scene, LightStrategy::Mis);
  return {scene, table, makeLightTree(scene, table)};
}

SceneBuilder& addLamp(SceneBuilder& builder, const Vec3d& at, const Vec3d& normal, double size,
                      float radiance) {
  const Vec3d side =
      glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.7 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0)));
  const Vec3d up = glm::cross(normal, side);
  return builder.triangle(at, at + size * side, at + size * up, emitter(Vec3f(radiance)));
}

/// Lamps of all sizes, brightnesses and directions.
Built scattered(int count, std::uint32_t seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 3.0, diffuse(Vec3f(0.5F)));
  for (int i = 0; i < count; ++i) {
    const Vec3d normal = glm::normalize(Vec3d(unit(engine), unit(engine), unit(engine)) + Vec3d(1e-3));
    addLamp(builder, 2.0 * Vec3d(unit(engine), unit(engine), unit(engine)), normal,
            0.01 + 0.1 * std::abs(unit(engine)), static_cast<float>(1.0 + unit(engine) * 0.9));
  }
  return treeOf(builder.build());
}

std::uint32_t depthOf(const LightTree& tree, std::uint32_t node) {
  std::uint32_t depth = 0;
  for (; node != 0; node = tree.nodes[node].parent)
    ++depth;
  return depth;
}

void expectWhole(const Built& b) {
  ASSERT_EQ(b.tree.leafOfLight.size(), b.table.lights.size());
  ASSERT_EQ(b.tree.nodes.size(), 2 * b.table.lights.size());
  for (std::uint32_t light = 0; light < b.table.lights.size(); ++light) {
    const LightTreeNode& leaf = b.tree.nodes[b.tree.leafOfLight[light]];
    EXPECT_TRUE(leaf.leaf);
    EXPECT_EQ(leaf.below, light);
    EXPECT_DOUBLE_EQ(leaf.bounds.power, b.table.lights[light].probability);
    EXPECT_LE(depthOf(b.tree, b.tree.leafOfLight[light]), shared::kMaxLightTreeDepth);
  }
  EXPECT_NEAR(b.tree.nodes[0].bounds.power, 1.0, 1e-12);
  for (std::uint32_t i = 0; i < b.tree.nodes.size(); ++i) {
    const LightTreeNode& node = b.tree.nodes[i];
    if (i == 1 || node.leaf)
      continue;
    EXPECT_EQ(node.below % 2, 0U) << "siblings are told apart by their last bit";
    double power = 0.0;
    for (const std::uint32_t child : {node.below, node.below + 1}) {
      EXPECT_EQ(b.tree.nodes[child].parent, i);
      power += b.tree.nodes[child].bounds.power;
    }
    EXPECT_NEAR(power, node.bounds.power, 1e-12);
  }
}

TEST(LightTree, EveryLightHasOneLeaf) {
  for (const int count : {1, 2, 3, 17, 1000})
    expectWhole(scattered(count, 7));
}

/// Every lamp's corners and normal lie within the bounds of all nodes above it.
TEST(LightTree, BoundsHoldOnTheWholeWayUp) {
  const Built b = scattered(300, 11);
  for (std::uint32_t light = 0; light < b.table.lights.size(); ++light) {
    const Triangle& t = b.scene.triangles[b.table.lights[light].index];
    std::array<Vec3d, 3> v;
    for (std::size_t i = 0; i < 3; ++i)
      v[i] = b.scene.positions[t.vertex[i]];
    const Vec3d n = glm::normalize(glm::cross(v[1] - v[0], v[2] - v[0]));
    std::uint32_t node = b.tree.leafOfLight[light];
    for (bool top = false; !top; node = b.tree.nodes[node].parent) {
      top = node == 0;
      const LightBounds& bounds = b.tree.nodes[node].bounds;
      for (const Vec3d& p : v) {
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(p, bounds.box.lower)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(p, bounds.box.upper)));
      }
      EXPECT_NEAR(glm::length(bounds.axis), 1.0, 1e-12);
      EXPECT_GE(glm::dot(n, bounds.axis), bounds.cosSpread - 1e-9);
    }
  }
}

LightBounds cone(const Vec3d& axis, double spread) {
  LightBounds b;
  b.box.extend(Vec3d(0.0));
  b.axis = glm::normalize(axis);
  b.cosSpread = std::cos(spread);
  b.power = 1.0;
  return b;
}

TEST(LightTree, AConeAboutTwoConesIsNoWiderThanItMustBe) {
  constexpr double kPi = std::numbers::pi;
  const auto spread = [](const LightBounds& a, const LightBounds& b) {
    return std::acos(unite(a, b).cosSpread);
  };
  const Vec3d x(1, 0, 0);
  const Vec3d y(0, 1, 0);
  EXPECT_NEAR(spread(cone(x, 0.0), cone(x, 0.0)), 0.0, 1e-6);
  EXPECT_NEAR(spread(cone(x, 0.0), cone(y, 0.0)), 0.25 * kPi, 1e-9);
  EXPECT_NEAR(spread(cone(x, 0.2), cone(y, 0.1)), 0.25 * kPi + 0.15, 1e-9);
  EXPECT_NEAR(spread(cone(x, 1.0), cone(x + 0.1 * y, 0.1)), 1.0, 1e-9) << "one within the other";
  EXPECT_NEAR(spread(cone(x + 0.1 * y, 0.1), cone(x, 1.0)), 1.0, 1e-9);
  EXPECT_NEAR(spread(cone(x, 0.0), cone(-x, 0.0)), kPi, 1e-6) << "opposite: all directions";
  EXPECT_NEAR(spread(cone(x, 2.0), cone(-x, 2.0)), kPi, 1e-6);
  EXPECT_NEAR(spread(cone(x, kPi), cone(y, 0.1)), kPi, 1e-6);
}

/// Each four times as far and as large as the one before: any sensible cut parts the last from the others.
TEST(LightTree, StaysShallowWhereLightsLieEverFarther) {
  constexpr int kLamps = 120;
  SceneBuilder builder;
  for (int i = 0; i < kLamps; ++i)
    addLamp(builder, {1.0, 0.0, 0.0}, {0, 1, 0}, 0.1, 1.0F);
  Scene scene = builder.build();
  for (std::size_t i = 0; i < scene.positions.size(); ++i) // not recentred: the smallest would be lost
    scene.positions[i] = std::ldexp(1.0F, 2 * static_cast<int>(i / 3) - kLamps) *
                         (Vec3f(1.0F, 0.0F, 0.0F) + 0.1F * Vec3f(i % 3 == 1, 0.0F, i % 3 == 2));
  for (Triangle& t : scene.triangles)
    std::swap(t.vertex[1], t.vertex[2]);
  expectWhole(treeOf(scene));
}

TEST(LightTree, LightsInOnePlaceArePartedAnyhow) {
  SceneBuilder builder;
  for (int i = 0; i < 333; ++i)
    addLamp(builder, {0.5, 0.25, 0.0}, {0, 1, 0}, 0.1, 1.0F + static_cast<float>(i));
  expectWhole(treeOf(builder.build()));
}

/// Nodes look at what is infinitely far from all of the scene.
TEST(LightTree, FarLightsHaveTheScenesBox) {
  const Built b = treeOf(everything());
  expectWhole(b);
  Box3d whole;
  for (const Vec3f& p : b.scene.positions)
    whole.extend(Vec3d(p));
  int far = 0;
  for (std::uint32_t i = 0; i < b.table.lights.size(); ++i) {
    const LightSource::Kind kind = b.table.lights[i].kind;
    const LightBounds& bounds = b.tree.nodes[b.tree.leafOfLight[i]].bounds;
    EXPECT_EQ(bounds.cosSpread, kind == LightSource::Kind::Triangle ? 1.0 : -1.0);
    if (kind != LightSource::Kind::Directional && kind != LightSource::Kind::Environment)
      continue;
    ++far;
    EXPECT_EQ(bounds.box.lower, whole.lower);
    EXPECT_EQ(bounds.box.upper, whole.upper);
  }
  EXPECT_EQ(far, 2);
}

} // namespace
} // namespace vkpt::test
