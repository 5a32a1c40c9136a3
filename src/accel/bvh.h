#pragma once
// A four-wide bounding volume hierarchy over triangles, in the layout the device reads.

#include "core/math.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vkpt {

inline constexpr std::uint32_t kBvhWidth = 4;
inline constexpr std::uint32_t kMaxLeafTriangles = 4;
inline constexpr std::size_t kMaxBvhTriangles = std::size_t{1} << 28U; ///< what a child reference can address

/// Reference to a child: an inner node's index, or a leaf's first triangle (in BVH order) and count.
/// Bit 31: leaf; bits 28-30: count - 1 (1..8); bits 0-27: first triangle. Inner: bits 0-30, the node's index.
namespace child_ref {
inline constexpr std::uint32_t kLeafBit = 0x80000000U;
inline constexpr std::uint32_t kFirstMask = 0x0FFFFFFFU;
constexpr std::uint32_t leaf(std::uint32_t first, std::uint32_t count) {
  return kLeafBit | ((count - 1U) << 28U) | first;
}
constexpr bool isLeaf(std::uint32_t r) { return (r & kLeafBit) != 0U; }
constexpr std::uint32_t first(std::uint32_t r) { return r & kFirstMask; }
constexpr std::uint32_t count(std::uint32_t r) { return ((r >> 28U) & 7U) + 1U; }
/// What an absent child refers to: triangle 0. No finite scene reaches its box at `kFarBox`, but a ray along
/// (1, 1, 1) with an unlimited tMax does; it then tests triangle 0, a real one, and so finds nothing untrue.
/// A device buffer of an empty scene therefore holds one degenerate triangle.
inline constexpr std::uint32_t kAbsent = leaf(0, 1);
} // namespace child_ref

/// 128 bytes, eight 16-byte texels: bounds of four children, then their references. Absent children come
/// last, refer to `child_ref::kAbsent` and have a degenerate box at `kFarBox` on every axis (never an
/// inverted one: a min/max slab test would accept it).
struct BvhNode {
  std::array<float, 4> lowerX, upperX, lowerY, upperY, lowerZ, upperZ;
  std::array<std::uint32_t, 4> child;
  std::array<std::uint32_t, 4> unused{};
};
static_assert(sizeof(BvhNode) == 128);
inline constexpr float kFarBox = 1e30F;

/// Nodes stand depth-first, the inner children of one node side by side.
struct Bvh {
  std::vector<BvhNode> nodes;               ///< [0] is the root; never empty
  std::vector<std::uint32_t> triangleOrder; ///< BVH position -> input triangle; a permutation
  std::uint32_t depth = 0;                  ///< nodes on the longest path from the root, >= 1
  /// Entries a depth-first traversal needs at most (3 more per level than it pops, and slack).
  [[nodiscard]] std::uint32_t stackSize() const { return 3U * depth + 4U; }
};

struct BvhSettings {
  /// Of the four-wide tree; where the best one is deeper, kept by excluding splits that would leave too many
  /// triangles for the levels below. Raised to `smallestBvhDepth`, where even a balanced tree is deeper; 48
  /// is enough for every input.
  std::uint32_t maxDepth = 48;
  unsigned threads = 0; ///< 0: as many as the machine has
};

/// Depth of a balanced four-wide tree over so many triangles: no smaller limit can be kept.
std::uint32_t smallestBvhDepth(std::size_t triangles);

/// Builds by binned surface area heuristic (Wald 2007, "On fast construction of SAH-based BVHs"), moves
/// subtrees to where they cost less, and collapses to four children at the least cost; greedily without
/// moving where that would be deeper than the limit. `bounds[i]` is triangle i's box: finite, not empty, at
/// most `kMaxBvhTriangles` of them (asserted). A node's boxes are the exact float minima and maxima of what
/// they hold. The result does not depend on `threads`. No triangles: a root with four absent children.
Bvh buildBvh(std::span<const Box3f> bounds, const BvhSettings& settings = {});

} // namespace vkpt
