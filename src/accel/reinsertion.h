#pragma once
// Subtrees that are moved to where they cost less.

#include "accel/linked_tree.h"

namespace vkpt::accel {

/// Sum of the inner nodes' surfaces over the root's: what moving lowers.
double innerSurface(const LinkedTree& tree);

/// Takes out subtrees, the largest first, and puts each where the sum of the inner nodes' surfaces becomes
/// smallest (Bittner, Hapala, Havran 2013, "Fast insertion-based optimization of bounding volume
/// hierarchies"; the search: Meister, Bittner 2018, "Parallel reinsertion for bounding volume hierarchy
/// optimization"). The sum never grows. In a large tree the largest nodes alone are tried: they are most of
/// the sum.
void reinsert(LinkedTree& tree);

} // namespace vkpt::accel
