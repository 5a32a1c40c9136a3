#pragma once
// The binary tree that the four-wide one is collapsed from.

#include "accel/bvh.h"
#include "accel/primitive.h"
#include "accel/workers.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace vkpt::accel {

/// The box of an absent child.
inline constexpr Bounds kAbsentBounds{{kFarBox, kFarBox, kFarBox, 0.0F}, {kFarBox, kFarBox, kFarBox, 0.0F}};

/// An inner node. Children are referred to as in `child_ref`; leaves have no node of their own.
struct BinaryNode {
  std::array<Bounds, 2> bounds;
  std::array<std::uint32_t, 2> child;
  std::uint32_t height; ///< inner nodes on the longest way down, this one included
};

/// A parent has a smaller index than its children; beyond that, indices depend on how the threads ran. Shape,
/// boxes and the order of the primitives do not. Empty by default.
struct BinaryBvh {
  std::unique_ptr<BinaryNode[]> nodes;
  std::size_t nodeCount = 0;
  Bounds bounds = kAbsentBounds;
  std::uint32_t root = child_ref::kAbsent; ///< a node, or a leaf where everything fits in one
};

/// Levels of inner nodes that a balanced tree over so many primitives has.
std::uint32_t balancedLevels(std::size_t primitives);

/// Whether small ranges become leaves where that is cheaper, or single primitives do as far as the levels go.
enum class Leaves : std::uint8_t { Cheapest, Single };

/// Permutes `primitives` (at least one) so that each leaf is a range of them. The tree has at most `levels`
/// levels of inner nodes, which must be `balancedLevels` or more.
BinaryBvh buildBinaryBvh(std::span<Primitive> primitives, std::uint32_t levels, Leaves leaves,
                         Workers& workers);

/// Sets the height of every node.
void setHeights(BinaryBvh& tree);

} // namespace vkpt::accel
