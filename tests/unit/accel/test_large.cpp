// A million triangles, placed so that trees over them tend to go wrong.

#include "unit/accel/bvh_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

constexpr std::size_t kMillion = 1'000'000;

void expectSound(const Mesh& mesh, std::uint32_t limit = 48) {
  const std::vector<Box3f> boxes = boxesOf(mesh);
  const Bvh bvh = buildBvh(boxes, {.maxDepth = limit});
  EXPECT_EQ(flawOf(bvh, boxes), "");
  EXPECT_LE(bvh.depth, limit);
}

TEST(BvhLarge, AtOnePoint) {
  expectSound(Mesh(kMillion, Triangle{Vec3f(0.25F), Vec3f(0.25F), Vec3f(0.25F)}));
}
TEST(BvhLarge, Coincident) { expectSound(coincident(kMillion)); }
TEST(BvhLarge, Concentric) { expectSound(concentric(kMillion)); }
TEST(BvhLarge, GeometricProgression) { expectSound(geometric(kMillion, 1.00008)); }
TEST(BvhLarge, SliverFan) { expectSound(sliverFan(kMillion)); }
TEST(BvhLarge, Needles) { expectSound(needles(kMillion, "a million needles")); }
TEST(BvhLarge, Surface) { expectSound(waves(708)); }
TEST(BvhLarge, SoupOfSize1e18) { expectSound(scaled(soup(kMillion, 0.01F, "a million"), 1e18F)); }
TEST(BvhLarge, BalancedByTheTightestLimit) {
  expectSound(geometric(kMillion, 1.00008), smallestBvhDepth(kMillion));
}

} // namespace
} // namespace vkpt::test
