// A ray finds through the tree what it finds by testing every triangle.

#include "unit/accel/bvh_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

/// Half of them from within the scene's box, half from outside towards a point in it.
std::vector<Ray> randomRays(const Mesh& mesh, std::size_t count, std::string_view seed) {
  Box3f whole;
  for (const Box3f& b : boxesOf(mesh))
    whole.extend(b);
  Random random(seed);
  const auto inside = [&] {
    const Vec3d u = random.inBox(0.0F, 1.0F);
    return Vec3d(whole.lower) + u * (Vec3d(whole.upper) - Vec3d(whole.lower));
  };
  const double size = glm::length(Vec3d(whole.upper) - Vec3d(whole.lower));
  std::vector<Ray> rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d target = inside();
    const Vec3d direction = random.direction();
    rays[i] = {i % 2 == 0 ? target : target - size * direction, direction};
  }
  return rays;
}

struct Outcome {
  std::size_t hits = 0, differences = 0;
};

Outcome compare(const Mesh& mesh, std::span<const Ray> rays, const BvhSettings& settings = {}) {
  const Bvh bvh = buildBvh(boxesOf(mesh), settings);
  Outcome o;
  for (const Ray& ray : rays) {
    const Hit expected = bruteForceHit(mesh, ray);
    o.hits += expected.triangle != ~0U ? 1U : 0U;
    o.differences += treeHit(bvh, mesh, ray) == expected ? 0U : 1U;
  }
  return o;
}

constexpr std::size_t kRays = 10000;

TEST(BvhHits, EqualBruteForceOnEveryKind) {
  const std::vector<NamedMesh> meshes{
      {"soup", soup(800, 0.1F, "hits")},
      {"dense soup", soup(300, 1.0F, "dense hits")},
      {"waves", waves(20)},
      {"flat grid", flatGrid(20)},
      {"sliver fan", sliverFan(600)},
      {"needles", needles(800, "needle hits")},
      {"coincident", coincident(300)},
      {"concentric", concentric(400)},
      {"geometric", geometric(100, 0.7)},
      {"soup of size 1e18", scaled(soup(500, 0.1F, "huge hits"), 1e18F)},
  };
  for (const NamedMesh& m : meshes) {
    const Outcome o = compare(m.mesh, randomRays(m.mesh, kRays, "rays at " + m.name));
    EXPECT_EQ(o.differences, 0U) << m.name;
    // A needle is hit once in a thousand tries; the rest are seen often.
    EXPECT_GT(o.hits, m.name == "needles" ? 10U : kRays / 50) << m.name;
  }
}

TEST(BvhHits, EqualBruteForceUnderTheTightestDepthLimit) {
  const Mesh mesh = together(soup(400, 0.1F, "tight"), geometric(120, 0.8));
  const Outcome o =
      compare(mesh, randomRays(mesh, kRays, "rays at tight"), {.maxDepth = smallestBvhDepth(520)});
  EXPECT_EQ(o.differences, 0U);
  EXPECT_GT(o.hits, kRays / 50);
}

TEST(BvhHits, EqualBruteForceForAHandfulOfTriangles) {
  for (const std::size_t n : {1U, 2U, 5U}) {
    const Mesh mesh = soup(n, 0.8F, "handful");
    const Outcome o = compare(mesh, randomRays(mesh, kRays, "rays at a handful"));
    EXPECT_EQ(o.differences, 0U) << n;
    EXPECT_GT(o.hits, kRays / 50) << n;
  }
}

TEST(BvhHits, AnEmptyTreeIsMissed) {
  const Bvh bvh = buildBvh({});
  Random random("empty");
  for (std::size_t i = 0; i < kRays; ++i)
    EXPECT_EQ(trianglesTested(bvh, {random.inBox(-1.0F, 1.0F), random.direction()}), 0U);
}

/// The one direction that meets the boxes of absent children: once, triangle 0, and never below their
/// distance.
TEST(BvhHits, ARayAlongTheDiagonalMeetsAbsentChildrenHarmlessly) {
  const Mesh one = coincident(1);
  const Bvh bvh = buildBvh(boxesOf(one));
  const Ray diagonal{Vec3d(-4.0), glm::normalize(Vec3d(1.0))};
  EXPECT_EQ(treeHit(bvh, one, diagonal), bruteForceHit(one, diagonal));
  EXPECT_GT(trianglesTested(bvh, diagonal), 1U);
  EXPECT_EQ(trianglesTested(bvh, {diagonal.origin, diagonal.direction, 1e29}), 1U);
}

} // namespace
} // namespace vkpt::test
