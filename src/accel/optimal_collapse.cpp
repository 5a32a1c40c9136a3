#include "accel/optimal_collapse.h"

#include "accel/collapse.h"
#include "accel/sah_split.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace vkpt::accel {

namespace {

/// Least costs of a subtree as so many children of the four-wide node above it, in the root's surface.
struct Costs {
  std::array<float, kBvhWidth> as{}; ///< [i]: as i + 1 of them, or fewer
  /// [i]: of i + 1 children so many are below the left child; 0: no more than i are cheaper
  std::array<std::uint8_t, kBvhWidth> left{};
  std::uint32_t first = 0, count = 0; ///< triangles, in the new order
  std::uint8_t leftOfFour = 0;        ///< where the subtree is a node itself
  bool isLeaf = false;
};

class OptimalCollapse {
public:
  OptimalCollapse(const LinkedTree& tree, std::span<const Primitive> primitives)
      : m_tree(tree), m_primitives(primitives), m_costs(tree.nodes.size()) {}

  Bvh run() {
    for (const std::uint32_t node : m_tree.childrenFirst())
      judge(node);
    m_bvh.depth = 1;
    m_bvh.nodes.push_back(absentNode());
    if (m_costs[0].isLeaf)
      setChild(m_bvh.nodes[0], 0, m_tree.nodes[0].bounds, leafRef(0));
    else
      emitNodes();
    return std::move(m_bvh);
  }

private:
  void judge(std::uint32_t node) {
    const LinkedNode& n = m_tree.nodes[node];
    Costs& c = m_costs[node];
    const auto surface = static_cast<float>(m_measure(n.bounds) / m_whole);
    if (n.isLeaf()) {
      c.first = static_cast<std::uint32_t>(m_bvh.triangleOrder.size());
      c.count = n.count;
      for (const Primitive& p : m_primitives.subspan(n.first, n.count))
        m_bvh.triangleOrder.push_back(p.index());
      c.isLeaf = true;
      c.as.fill(leafCost(surface, n.count));
      return;
    }
    const Costs& l = m_costs[n.child[0]];
    const Costs& r = m_costs[n.child[1]];
    c.first = l.first;
    c.count = l.count + r.count;
    std::array<float, kBvhWidth> parted{}; // [i]: as i + 1 children, at least one from either side
    for (std::uint8_t i = 1; i < kBvhWidth; ++i) {
      parted[i] = l.as[0] + r.as[i - 1U];
      c.left[i] = 1;
      for (std::uint8_t k = 1; k < i; ++k) {
        const float cost = l.as[k] + r.as[i - 1U - k];
        if (cost < parted[i]) {
          parted[i] = cost;
          c.left[i] = static_cast<std::uint8_t>(k + 1U);
        }
      }
    }
    c.leftOfFour = c.left[kBvhWidth - 1];
    c.as[0] = static_cast<float>(kWideNodeCost) * surface + parted[kBvhWidth - 1];
    if (c.count <= kMaxLeafTriangles && leafCost(surface, c.count) <= c.as[0]) {
      c.as[0] = leafCost(surface, c.count);
      c.isLeaf = true;
    }
    for (std::uint8_t i = 1; i < kBvhWidth; ++i) {
      if (parted[i] < c.as[i - 1U]) {
        c.as[i] = parted[i];
      } else {
        c.as[i] = c.as[i - 1U];
        c.left[i] = 0;
      }
    }
  }
  static float leafCost(float surface, std::uint32_t count) {
    return static_cast<float>(kTriangleCost) * surface * static_cast<float>(count);
  }
  [[nodiscard]] std::uint32_t leafRef(std::uint32_t node) const {
    return child_ref::leaf(m_costs[node].first, m_costs[node].count);
  }

  /// The children that a node takes in, from left to right.
  struct Children {
    std::array<std::uint32_t, kBvhWidth> node{};
    std::uint32_t count = 0;
  };
  /// What is below `node` as `as` children at most.
  void gather(std::uint32_t node, std::uint32_t as, Children& c) const {
    while (as > 1 && m_costs[node].left[as - 1] == 0)
      --as;
    if (as == 1)
      c.node[c.count++] = node;
    else
      part(node, m_costs[node].left[as - 1], as, c);
  }
  void part(std::uint32_t node, std::uint32_t left, std::uint32_t of, Children& c) const {
    gather(m_tree.nodes[node].child[0], left, c);
    gather(m_tree.nodes[node].child[1], of - left, c);
  }

  void emitNodes() {
    struct Open {
      std::uint32_t source, node, depth;
    };
    std::vector<Open> open{{0, 0, 1}};
    while (!open.empty()) {
      const Open o = open.back();
      open.pop_back();
      m_bvh.depth = std::max(m_bvh.depth, o.depth);
      Children c;
      part(o.source, m_costs[o.source].leftOfFour, kBvhWidth, c);
      for (std::uint32_t i = 0; i < c.count; ++i) {
        std::uint32_t ref = leafRef(c.node[i]);
        if (!m_costs[c.node[i]].isLeaf) {
          ref = static_cast<std::uint32_t>(m_bvh.nodes.size());
          open.push_back({c.node[i], ref, o.depth + 1});
          m_bvh.nodes.push_back(absentNode());
        }
        setChild(m_bvh.nodes[o.node], i, m_tree.nodes[c.node[i]].bounds, ref);
      }
    }
  }

  const LinkedTree& m_tree;
  std::span<const Primitive> m_primitives;
  std::vector<Costs> m_costs;
  SurfaceMeasure m_measure{m_tree.nodes[0].bounds};
  double m_whole = std::max(m_measure(m_tree.nodes[0].bounds), 1e-300);
  Bvh m_bvh;
};

} // namespace

Bvh collapseOptimally(const LinkedTree& tree, std::span<const Primitive> primitives) {
  return OptimalCollapse(tree, primitives).run();
}

} // namespace vkpt::accel
