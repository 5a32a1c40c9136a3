#include "accel/linked_tree.h"

#include <algorithm>

namespace vkpt::accel {

LinkedTree::LinkedTree(const BinaryBvh& tree) {
  struct Open {
    std::uint32_t ref, parent, side;
    const Bounds* bounds;
  };
  nodes.reserve(2 * tree.nodeCount + 1);
  std::vector<Open> open{{tree.root, kNoNode, 0, &tree.bounds}};
  while (!open.empty()) {
    const Open o = open.back();
    open.pop_back();
    const auto id = static_cast<std::uint32_t>(nodes.size());
    LinkedNode& n = nodes.emplace_back();
    n.bounds = *o.bounds;
    n.parent = o.parent;
    if (o.parent != kNoNode)
      nodes[o.parent].child[o.side] = id;
    if (child_ref::isLeaf(o.ref)) {
      n.first = child_ref::first(o.ref);
      n.count = child_ref::count(o.ref);
    } else {
      const BinaryNode& b = tree.nodes[o.ref];
      open.push_back({b.child[1], id, 1, &b.bounds[1]});
      open.push_back({b.child[0], id, 0, &b.bounds[0]});
    }
  }
}

std::vector<std::uint32_t> LinkedTree::childrenFirst() const {
  std::vector<std::uint32_t> order;
  order.reserve(nodes.size());
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    open.pop_back();
    order.push_back(i);
    if (!nodes[i].isLeaf())
      open.insert(open.end(), nodes[i].child.begin(), nodes[i].child.end()); // the right one is taken first
  }
  std::reverse(order.begin(), order.end());
  return order;
}

} // namespace vkpt::accel
