// The depth limit, on meshes whose best tree is deep.

#include "unit/accel/bvh_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

TEST(BvhDepth, SmallestDepthIsThatOfABalancedTree) {
  EXPECT_EQ(smallestBvhDepth(0), 1U);
  EXPECT_EQ(smallestBvhDepth(16), 1U);
  EXPECT_EQ(smallestBvhDepth(17), 2U);
  EXPECT_EQ(smallestBvhDepth(64), 2U);
  EXPECT_EQ(smallestBvhDepth(65), 3U);
  EXPECT_EQ(smallestBvhDepth(std::size_t{1} << 20U), 9U);
  EXPECT_EQ(smallestBvhDepth((std::size_t{1} << 20U) + 1), 10U);
  EXPECT_LE(smallestBvhDepth(kMaxBvhTriangles), BvhSettings().maxDepth);
}

TEST(BvhDepth, NoLimitIsExceeded) {
  for (const NamedMesh& m : allKinds()) {
    const std::vector<Box3f> boxes = boxesOf(m.mesh);
    for (const std::uint32_t limit : {6U, 7U, 8U, 9U, 12U, 20U, 48U, ~0U}) {
      const Bvh bvh = buildBvh(boxes, {.maxDepth = limit});
      EXPECT_LE(bvh.depth, limit) << m.name;
      EXPECT_EQ(flawOf(bvh, boxes), "") << m.name << ", limit " << limit;
    }
  }
}

/// Exactly as many triangles as so many levels can hold, and limits that cannot be kept at all.
TEST(BvhDepth, ABalancedTreeWhereNothingElseFits) {
  for (const std::size_t n : {16U, 17U, 63U, 64U, 65U, 1023U, 1024U, 1025U, 4096U, 4097U}) {
    for (const Mesh& mesh : {soup(n, 0.1F, "balanced"), coincident(n), geometric(n, 1.01), sliverFan(n)}) {
      const std::vector<Box3f> boxes = boxesOf(mesh);
      for (const std::uint32_t limit : {0U, 1U, smallestBvhDepth(n)}) {
        const Bvh bvh = buildBvh(boxes, {.maxDepth = limit});
        EXPECT_EQ(bvh.depth, smallestBvhDepth(n)) << n;
        EXPECT_EQ(flawOf(bvh, boxes), "") << n << ", limit " << limit;
      }
    }
  }
}

/// The limit is met by giving up the best cuts: without one, this tree is deeper. Without it no test here
/// would say anything.
TEST(BvhDepth, SomeMeshesAreDeepByThemselves) {
  const std::vector<Box3f> boxes = boxesOf(geometric(240, 0.5));
  const std::uint32_t own = buildBvh(boxes, {.maxDepth = ~0U}).depth;
  EXPECT_GT(own, 3U * smallestBvhDepth(boxes.size()));
  EXPECT_EQ(buildBvh(boxes, {.maxDepth = own}).depth, own);
  EXPECT_LT(buildBvh(boxes, {.maxDepth = own - 1}).depth, own);
}

} // namespace
} // namespace vkpt::test
