#include "accel/collapse.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace vkpt::accel {

namespace {

/// The children of a four-wide node while they are being chosen.
struct Children {
  std::uint32_t count = 0;
  std::array<std::uint32_t, kBvhWidth> ref{};
  std::array<const Bounds*, kBvhWidth> bounds{};

  /// Puts the children of `node` where child `at` was.
  void replace(std::uint32_t at, const BinaryNode& node) {
    for (std::uint32_t i = count; i > at + 1; --i) {
      ref[i] = ref[i - 1];
      bounds[i] = bounds[i - 1];
    }
    for (std::uint32_t i = 0; i < 2; ++i) {
      ref[at + i] = node.child[i];
      bounds[at + i] = &node.bounds[i];
    }
    ++count;
  }
};

/// The child to open next, or `count` where all are leaves. A subtree of height h makes ceil(h / 2) levels if
/// both children of every node are opened; so one that is higher than twice `levelsBelow` must be opened
/// here. At most two can be, since their parent was no higher than twice (levelsBelow + 1).
std::uint32_t childToOpen(const BinaryBvh& tree, const Children& c, std::uint32_t levelsBelow) {
  std::uint32_t best = c.count;
  std::pair bestSize{-1.0, 0.0};
  for (std::uint32_t i = 0; i < c.count; ++i) {
    if (child_ref::isLeaf(c.ref[i]))
      continue;
    if (tree.nodes[c.ref[i]].height > 2U * levelsBelow)
      return i;
    // By length where no box has an area.
    const std::pair size{c.bounds[i]->halfArea(), c.bounds[i]->length()};
    if (size > bestSize) {
      best = i;
      bestSize = size;
    }
  }
  return best;
}

Children chooseChildren(const BinaryBvh& tree, std::uint32_t node, std::uint32_t levelsBelow) {
  Children c;
  c.replace(0, tree.nodes[node]);
  c.count = 2;
  while (c.count < kBvhWidth) {
    const std::uint32_t i = childToOpen(tree, c, levelsBelow);
    if (i == c.count)
      break;
    c.replace(i, tree.nodes[c.ref[i]]);
  }
  return c;
}

} // namespace

void setChild(BvhNode& node, std::uint32_t i, const Bounds& b, std::uint32_t ref) {
  node.lowerX[i] = b.lower[0];
  node.lowerY[i] = b.lower[1];
  node.lowerZ[i] = b.lower[2];
  node.upperX[i] = b.upper[0];
  node.upperY[i] = b.upper[1];
  node.upperZ[i] = b.upper[2];
  node.child[i] = ref;
}

BvhNode absentNode() {
  BvhNode node{};
  for (std::uint32_t i = 0; i < kBvhWidth; ++i)
    setChild(node, i, kAbsentBounds, child_ref::kAbsent);
  return node;
}

Bvh collapse(const BinaryBvh& tree, std::uint32_t maxDepth) {
  Bvh bvh;
  bvh.depth = 1;
  bvh.nodes.reserve(tree.nodeCount / 2 + 1);
  bvh.nodes.push_back(absentNode());
  if (child_ref::isLeaf(tree.root)) {
    setChild(bvh.nodes[0], 0, tree.bounds, tree.root);
    return bvh;
  }
  assert(tree.nodes[tree.root].height <= 2U * maxDepth);
  struct Open {
    std::uint32_t source, node, depth;
  };
  std::vector<Open> open{{tree.root, 0, 1}};
  while (!open.empty()) {
    const Open o = open.back();
    open.pop_back();
    bvh.depth = std::max(bvh.depth, o.depth);
    const Children c = chooseChildren(tree, o.source, maxDepth - o.depth);
    for (std::uint32_t i = 0; i < c.count; ++i) {
      std::uint32_t ref = c.ref[i];
      if (!child_ref::isLeaf(ref)) {
        open.push_back({ref, static_cast<std::uint32_t>(bvh.nodes.size()), o.depth + 1});
        ref = open.back().node;
        bvh.nodes.push_back(absentNode());
      }
      setChild(bvh.nodes[o.node], i, *c.bounds[i], ref);
    }
  }
  return bvh;
}

} // namespace vkpt::accel
