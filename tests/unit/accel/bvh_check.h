#pragma once
// What must be true of any tree, and a plain traversal in double to compare with.

#include "accel/bvh.h"
#include "unit/accel/meshes.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>

namespace vkpt::test {

/// Empty where the tree is sound; else one line about the first thing that is not: every triangle in exactly
/// one leaf, leaves of 1 to kMaxLeafTriangles, every box exactly the union of what is below it, every node
/// reached once, absent children last and at kFarBox, depth as stated, stackSize() enough for a traversal
/// that pushes every child.
std::string flawOf(const Bvh& bvh, std::span<const Box3f> boxes);

/// Expected cost of a random ray that meets the root's box: nodes visited plus triangles tested, a node
/// costing `nodeCost` triangles.
double expectedCost(const Bvh& bvh, double nodeCost);

/// Leaves of each size 1..4.
std::array<std::size_t, kMaxLeafTriangles> leafSizes(const Bvh& bvh);

struct Ray {
  Vec3d origin, direction;
  double tMax = std::numeric_limits<double>::infinity();
};
struct Hit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t triangle = ~0U;
  bool operator==(const Hit&) const = default;
};
/// Closest hit by testing every triangle; of equal ones, the one with the smallest index.
Hit bruteForceHit(const Mesh& mesh, const Ray& ray);
/// The same through the tree.
Hit treeHit(const Bvh& bvh, const Mesh& mesh, const Ray& ray);
/// Leaf triangles that `treeHit` tests.
std::size_t trianglesTested(const Bvh& bvh, const Ray& ray);

} // namespace vkpt::test
