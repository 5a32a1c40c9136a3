#pragma once
// From two children a node to four, and from triangles to leaves, at the least expected cost.

#include "accel/bvh.h"
#include "accel/linked_tree.h"

#include <span>

namespace vkpt::accel {

/// The cheapest of all trees that take in nodes of `tree`, by dynamic programming: for each node the least
/// cost of it as one child, and of what is below it as two to four (as in Ylitie, Karras, Laine 2017,
/// "Efficient incoherent ray traversal on GPUs through compressed wide BVHs"). Any subtree of up to
/// `kMaxLeafTriangles` may become a leaf. Sets the order of the triangles, too.
Bvh collapseOptimally(const LinkedTree& tree, std::span<const Primitive> primitives);

} // namespace vkpt::accel
