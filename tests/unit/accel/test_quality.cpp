// How good the trees are, against the exact heuristic and against none.

#include "accel/sah_split.h"
#include "unit/accel/bvh_check.h"
#include "unit/accel/exact_sweep.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

/// The bound is a choice, not an error estimate: bins may cost a twentieth.
void expectNearlyExact(const Mesh& mesh, double bound) {
  const std::vector<Box3f> boxes = boxesOf(mesh);
  const Bvh exact = buildByExactSweep(boxes);
  ASSERT_EQ(flawOf(exact, boxes), "");
  const double binned = expectedCost(buildBvh(boxes), 1.0);
  const double swept = expectedCost(exact, 1.0);
  testing::Test::RecordProperty("ratio", std::to_string(binned / swept));
  EXPECT_LE(binned, bound * swept) << binned << " against " << swept;
}

TEST(BvhQuality, BinsCostLittleOnASurface) { expectNearlyExact(waves(224), 1.05); }
TEST(BvhQuality, BinsCostLittleOnASoup) { expectNearlyExact(soup(100'000, 0.02F, "quality"), 1.05); }
TEST(BvhQuality, BinsCostLittleOnUnequalSizes) {
  expectNearlyExact(together(soup(50'000, 0.3F, "large ones"), soup(50'000, 0.003F, "small ones")), 1.05);
}

/// A price of nodes far too low would give each triangle a leaf of its own, one far too high only full
/// leaves.
TEST(BvhQuality, ManyTrianglesShareALeafAndNotAllLeavesAreFull) {
  for (const Mesh& mesh : {waves(100), soup(20'000, 0.02F, "leaves")}) {
    const auto sizes = leafSizes(buildBvh(boxesOf(mesh)));
    EXPECT_GT(sizes[1] + sizes[2] + sizes[3], 0U);
    EXPECT_GT(sizes[0] + sizes[1] + sizes[2], sizes[3]);
  }
}

/// Scaling by a power of two is exact, so nothing may change: no area overflows, none vanishes.
TEST(BvhQuality, ScaleDoesNotMatter) {
  const Mesh mesh = soup(5000, 0.05F, "scale");
  const std::vector<std::uint32_t> order = buildBvh(boxesOf(mesh)).triangleOrder;
  for (const float scale : {0x1p-100F, 0x1p-60F, 0x1p60F, 0x1p100F, 0x1p126F})
    EXPECT_EQ(buildBvh(boxesOf(scaled(mesh, scale))).triangleOrder, order) << scale;
}

accel::Primitive pointAt(float x, float y, float z) {
  accel::Primitive p;
  p.lower = p.upper = {x, y, z, 0.0F};
  return p;
}

TEST(BinMap, SpreadsCentroidsFromTheFirstBinToTheLast) {
  const accel::Primitive low = pointAt(-1.0F, 3.0F, 0.0F);
  const accel::Primitive middle = pointAt(0.5F, 3.0F, 0.0F);
  const accel::Primitive high = pointAt(2.0F, 3.0F, 0x1p-140F); // an extent too small to divide by
  accel::Extent extent = accel::Extent::none();
  for (const accel::Primitive& p : {low, middle, high})
    extent.extend(p);
  const accel::BinMap map(extent.centroids, 1000);
  EXPECT_EQ(map.bin(low, 0), 0U);
  EXPECT_EQ(map.bin(middle, 0), map.bins() / 2);
  EXPECT_EQ(map.bin(high, 0), map.bins() - 1);
  for (const accel::Primitive& p : {low, middle, high}) {
    EXPECT_EQ(map.bin(p, 1), 0U);
    EXPECT_EQ(map.bin(p, 2), 0U);
  }
}

/// A depth limit that a balanced tree just meets still leaves the surface heuristic most of its choices.
TEST(BvhQuality, ALimitCostsLittleWhereItIsNotNeeded) {
  const std::vector<Box3f> boxes = boxesOf(waves(100));
  const std::uint32_t own = buildBvh(boxes).depth;
  EXPECT_EQ(expectedCost(buildBvh(boxes, {.maxDepth = own}), 1.0), expectedCost(buildBvh(boxes), 1.0));
  const double tightest = expectedCost(buildBvh(boxes, {.maxDepth = smallestBvhDepth(boxes.size())}), 1.0);
  EXPECT_LE(tightest, 2.0 * expectedCost(buildBvh(boxes), 1.0));
}

/// Boxes without any surface are weighed by their length: cut evenly, not one by one.
TEST(BvhQuality, TrianglesOnALineMakeABalancedTree) {
  const std::vector<Box3f> boxes = boxesOf(onLine(1 << 14));
  EXPECT_LE(buildBvh(boxes).depth, smallestBvhDepth(boxes.size()) + 2);
}

} // namespace
} // namespace vkpt::test
