// What every tree is: a partition of the triangles, in exact boxes, as deep as it says.

#include "unit/accel/bvh_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

TEST(BvhStructure, HoldsForEveryKindOfMesh) {
  for (const NamedMesh& m : allKinds()) {
    const std::vector<Box3f> boxes = boxesOf(m.mesh);
    EXPECT_EQ(flawOf(buildBvh(boxes), boxes), "") << m.name;
  }
}

TEST(BvhStructure, HoldsForEverySmallCount) {
  const Mesh mesh = soup(70, 0.1F, "small counts");
  for (std::size_t n = 0; n <= mesh.size(); ++n) {
    const std::vector<Box3f> boxes =
        boxesOf(Mesh(mesh.begin(), mesh.begin() + static_cast<std::ptrdiff_t>(n)));
    EXPECT_EQ(flawOf(buildBvh(boxes), boxes), "") << n << " triangles";
    const std::vector<Box3f> equal = boxesOf(coincident(n));
    EXPECT_EQ(flawOf(buildBvh(equal), equal), "") << n << " coincident triangles";
  }
}

/// Far above the size from which all threads split a range together: the boxes from such splits are still
/// there after the collapse.
TEST(BvhStructure, HoldsWhereRangesAreSplitInChunks) {
#ifdef __SANITIZE_ADDRESS__
  constexpr std::uint32_t kEdge = 150; // one such range
#else
  constexpr std::uint32_t kEdge = 230;
#endif
  constexpr std::size_t kCount = 2 * kEdge * kEdge;
  for (const Mesh& mesh : {waves(kEdge), soup(kCount, 0.01F, "chunks"), coincident(kCount)}) {
    const std::vector<Box3f> boxes = boxesOf(mesh);
    EXPECT_EQ(flawOf(buildBvh(boxes), boxes), "");
    EXPECT_EQ(flawOf(buildBvh(boxes, {.maxDepth = smallestBvhDepth(boxes.size())}), boxes), "");
  }
}

TEST(BvhStructure, NoTrianglesMakeARootWithoutChildren) {
  const Bvh bvh = buildBvh({});
  ASSERT_EQ(bvh.nodes.size(), 1U);
  EXPECT_EQ(bvh.depth, 1U);
  EXPECT_TRUE(bvh.triangleOrder.empty());
  for (std::uint32_t i = 0; i < kBvhWidth; ++i) {
    EXPECT_EQ(bvh.nodes[0].child[i], child_ref::kAbsent);
    EXPECT_EQ(bvh.nodes[0].lowerX[i], kFarBox);
    EXPECT_EQ(bvh.nodes[0].upperZ[i], kFarBox);
  }
}

TEST(BvhStructure, OneTriangleIsOneLeaf) {
  const std::vector<Box3f> boxes = boxesOf(coincident(1));
  const Bvh bvh = buildBvh(boxes);
  ASSERT_EQ(bvh.nodes.size(), 1U);
  EXPECT_EQ(bvh.nodes[0].child[0], child_ref::leaf(0, 1));
  EXPECT_EQ(bvh.nodes[0].lowerX[0], boxes[0].lower.x);
  EXPECT_EQ(bvh.nodes[0].lowerX[1], kFarBox);
}

TEST(BvhStructure, InnerChildrenStandSideBySideBehindTheirNode) {
  const Bvh bvh = buildBvh(boxesOf(waves(40)));
  for (std::uint32_t n = 0; n < bvh.nodes.size(); ++n) {
    std::uint32_t last = 0;
    for (const std::uint32_t c : bvh.nodes[n].child) {
      if (child_ref::isLeaf(c))
        continue;
      EXPECT_GT(c, n);
      if (last != 0) {
        EXPECT_EQ(c, last + 1);
      }
      last = c;
    }
  }
}

TEST(BvhStructure, ChildReferencesKeepTheirFields) {
  for (const std::uint32_t first : {0U, 1U, 12345U, child_ref::kFirstMask}) {
    for (std::uint32_t count = 1; count <= 8; ++count) {
      const std::uint32_t r = child_ref::leaf(first, count);
      EXPECT_TRUE(child_ref::isLeaf(r));
      EXPECT_EQ(child_ref::first(r), first);
      EXPECT_EQ(child_ref::count(r), count);
    }
  }
}

#ifndef NDEBUG
TEST(BvhStructureDeathTest, RefusesBoxesThatAreNotBoxes) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<Box3f> withNan{{Vec3f(0.0F), Vec3f(1.0F, nan, 1.0F)}};
  const std::vector<Box3f> infinite{{Vec3f(0.0F), Vec3f(1.0F, infinity, 1.0F)}};
  const std::vector<Box3f> inverted{{Vec3f(1.0F), Vec3f(0.0F)}};
  EXPECT_DEATH(buildBvh(withNan), "finite and not empty");
  EXPECT_DEATH(buildBvh(infinite), "finite and not empty");
  EXPECT_DEATH(buildBvh(inverted), "finite and not empty");
}
#endif

} // namespace
} // namespace vkpt::test
