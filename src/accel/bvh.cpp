#include "accel/bvh.h"

#include "accel/binary_bvh.h"
#include "accel/collapse.h"
#include "accel/linked_tree.h"
#include "accel/optimal_collapse.h"
#include "accel/reinsertion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace vkpt {

namespace {

/// Below this many triangles a second thread costs more than it saves.
constexpr std::size_t kMinThreadedTriangles = 8192;
/// Above this the tree stays as it is split: what makes it better takes 200 bytes and a microsecond a
/// triangle.
constexpr std::size_t kMaxOptimised = std::size_t{1} << 22U;
/// Levels of the binary tree where the four-wide one's depth is looked at in the end.
constexpr std::uint32_t kFreeLevels = 128;
constexpr std::size_t kBlock = std::size_t{1} << 16U;

[[maybe_unused]] bool isFiniteBox(const Box3f& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(b.lower[axis]) || !std::isfinite(b.upper[axis]))
      return false;
  }
  return !b.empty();
}

accel::Primitive makePrimitive(const Box3f& b, std::size_t index) {
  assert(isFiniteBox(b) && "a triangle's box is finite and not empty");
  accel::Primitive p;
  p.lower = {b.lower.x, b.lower.y, b.lower.z, 0.0F};
  p.upper = {b.upper.x, b.upper.y, b.upper.z, 0.0F};
  p.setIndex(static_cast<std::uint32_t>(index));
  return p;
}

/// Calls `body(i)` for each i < count, in blocks spread over the threads.
template<class Body>
void forBlocks(accel::Workers& workers, std::size_t count, const Body& body) {
  workers.forEach((count + kBlock - 1) / kBlock, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i)
      body(i);
  });
}

/// As deep as it is best.
Bvh buildBest(std::span<accel::Primitive> primitives, accel::Workers& workers) {
  accel::LinkedTree tree(accel::buildBinaryBvh(primitives, kFreeLevels, accel::Leaves::Single, workers));
  accel::reinsert(tree);
  return accel::collapseOptimally(tree, primitives);
}

} // namespace

std::uint32_t smallestBvhDepth(std::size_t triangles) {
  return std::max(1U, (accel::balancedLevels(triangles) + 1U) / 2U);
}

Bvh buildBvh(std::span<const Box3f> bounds, const BvhSettings& settings) {
  const std::size_t n = bounds.size();
  assert(n <= kMaxBvhTriangles);
  // No tree is deeper than its triangles are many.
  const auto limit = static_cast<std::uint32_t>(std::min<std::size_t>(settings.maxDepth, n));
  const std::uint32_t maxDepth = std::max(limit, smallestBvhDepth(n));
  if (n == 0)
    return accel::collapse({}, maxDepth);
  accel::Workers workers(n < kMinThreadedTriangles ? 1U : settings.threads);
  const auto storage = std::make_unique_for_overwrite<accel::Primitive[]>(n);
  const std::span primitives(storage.get(), n);
  const auto makePrimitives = [&] {
    forBlocks(workers, n, [&](std::size_t i) { primitives[i] = makePrimitive(bounds[i], i); });
  };
  makePrimitives();
  if (n <= kMaxOptimised) {
    Bvh bvh = buildBest(primitives, workers);
    if (bvh.depth <= maxDepth)
      return bvh;
    makePrimitives();
  }
  // Two binary levels make one of width four.
  const accel::BinaryBvh tree =
      accel::buildBinaryBvh(primitives, 2U * maxDepth, accel::Leaves::Cheapest, workers);
  Bvh bvh = accel::collapse(tree, maxDepth);
  bvh.triangleOrder.resize(n);
  forBlocks(workers, n, [&](std::size_t i) { bvh.triangleOrder[i] = primitives[i].index(); });
  return bvh;
}

} // namespace vkpt
