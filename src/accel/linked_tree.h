#pragma once
// The binary tree with links both ways, while it is made better: single triangles or small ranges at its
// leaves.

#include "accel/binary_bvh.h"
#include "accel/primitive.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vkpt::accel {

inline constexpr std::uint32_t kNoNode = ~0U;

struct LinkedNode {
  Bounds bounds;
  std::uint32_t parent = kNoNode; ///< of the root: none
  std::array<std::uint32_t, 2> child{kNoNode, kNoNode};
  std::uint32_t first = 0, count = 0; ///< a leaf's primitives
  [[nodiscard]] bool isLeaf() const { return child[0] == kNoNode; }
};

/// Nodes stand depth-first at the beginning, whatever their order in the binary tree: no result depends on
/// that.
struct LinkedTree {
  explicit LinkedTree(const BinaryBvh& tree);

  std::vector<LinkedNode> nodes; ///< [0] is the root and remains it
  [[nodiscard]] std::uint32_t sibling(std::uint32_t node) const {
    const LinkedNode& p = nodes[nodes[node].parent];
    return p.child[p.child[0] == node ? 1 : 0];
  }
  /// Every node after its children, the left child's before the right one's.
  [[nodiscard]] std::vector<std::uint32_t> childrenFirst() const;
};

} // namespace vkpt::accel
