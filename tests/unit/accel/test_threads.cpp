// The loop over threads, and that their number changes nothing.

#include "accel/workers.h"
#include "unit/accel/bvh_check.h"

#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

void expectIdentical(const Bvh& a, const Bvh& b, const std::string& name) {
  EXPECT_EQ(a.depth, b.depth) << name;
  EXPECT_EQ(a.triangleOrder, b.triangleOrder) << name;
  ASSERT_EQ(a.nodes.size(), b.nodes.size()) << name;
  EXPECT_EQ(std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(BvhNode)), 0) << name;
}

TEST(BvhThreads, TheNumberChangesNoBit) {
  // Zeros of both signs: a union that depended on the order of its parts would show.
  Mesh zeros = together(flatGrid(110), scaled(flatGrid(110), -1.0F));
  for (Triangle& t : zeros) {
    for (Vec3f& v : t)
      v.y *= 0.0F;
  }
  const std::vector<NamedMesh> meshes{{"waves", waves(140)},
                                      {"soup", soup(90000, 0.05F, "threads")},
                                      {"coincident", coincident(40000)},
                                      {"geometric", geometric(40000, 1.002)},
                                      {"zeros of both signs", zeros}};
  for (const NamedMesh& m : meshes) {
    const std::vector<Box3f> boxes = boxesOf(m.mesh);
    for (const std::uint32_t limit : {48U, smallestBvhDepth(boxes.size())}) {
      const Bvh one = buildBvh(boxes, {.maxDepth = limit, .threads = 1});
      for (const unsigned threads : {2U, 7U})
        expectIdentical(one, buildBvh(boxes, {.maxDepth = limit, .threads = threads}), m.name);
    }
  }
}

TEST(Workers, EachIterationRunsOnce) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    accel::Workers workers(threads);
    for (const std::size_t count : {0U, 1U, 3U, 1000U}) {
      std::vector<std::atomic<int>> runs(count);
      workers.forEach(count, [&](std::size_t i) { ++runs[i]; });
      for (const std::atomic<int>& r : runs)
        EXPECT_EQ(r, 1);
    }
  }
}

TEST(Workers, AnExceptionReachesTheCallerAndTheNextLoopRuns) {
  accel::Workers workers(3);
  const auto fail = [](std::size_t i) {
    if (i == 17)
      throw std::runtime_error("17");
  };
  EXPECT_THROW(workers.forEach(100, fail), std::runtime_error);
  std::atomic<int> runs{0};
  workers.forEach(100, [&](std::size_t) { ++runs; });
  EXPECT_EQ(runs, 100);
}

} // namespace
} // namespace vkpt::test
