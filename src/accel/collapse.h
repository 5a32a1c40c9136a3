#pragma once
// From two children a node to four.

#include "accel/binary_bvh.h"
#include "accel/bvh.h"

#include <cstdint>

namespace vkpt::accel {

/// Nodes and depth of the four-wide tree (the order of the triangles is the caller's). Each node takes in the
/// child of the largest surface, twice, unless a deeper one has to go first to keep to `maxDepth`, which must
/// be at least half the height of `tree` (rounded up) and 1.
Bvh collapse(const BinaryBvh& tree, std::uint32_t maxDepth);

void setChild(BvhNode& node, std::uint32_t i, const Bounds& b, std::uint32_t ref);
/// A node whose children are all absent.
BvhNode absentNode();

} // namespace vkpt::accel
