#include "unit/accel/exact_sweep.h"

#include "accel/collapse.h"
#include "accel/sah_split.h"

#include <algorithm>
#include <numeric>

namespace vkpt::test {

namespace {

class ExactBuilder {
public:
  explicit ExactBuilder(std::span<const Box3f> boxes) : m_boxes(boxes), m_order(boxes.size()) {
    std::iota(m_order.begin(), m_order.end(), 0U);
    m_tree.nodes = std::make_unique<accel::BinaryNode[]>(boxes.size());
  }

  Bvh build() {
    struct Range {
      std::size_t begin, end;
      std::uint32_t* ref;
      accel::Bounds* bounds;
    };
    std::vector<Range> open{{0, m_order.size(), &m_tree.root, &m_tree.bounds}};
    while (!open.empty()) {
      const Range r = open.back();
      open.pop_back();
      *r.bounds = toBounds(unionOf(r.begin, r.end));
      const std::size_t cut = bestCut(r.begin, r.end);
      if (cut == r.end) {
        *r.ref =
            child_ref::leaf(static_cast<std::uint32_t>(r.begin), static_cast<std::uint32_t>(r.end - r.begin));
        continue;
      }
      *r.ref = static_cast<std::uint32_t>(m_tree.nodeCount++);
      accel::BinaryNode& n = m_tree.nodes[*r.ref];
      open.push_back({r.begin, cut, &n.child[0], &n.bounds[0]});
      open.push_back({cut, r.end, &n.child[1], &n.bounds[1]});
    }
    accel::setHeights(m_tree);
    Bvh bvh = accel::collapse(m_tree, 1000);
    bvh.triangleOrder = m_order;
    return bvh;
  }

private:
  static accel::Bounds toBounds(const Box3f& b) {
    return {{b.lower.x, b.lower.y, b.lower.z, 0.0F}, {b.upper.x, b.upper.y, b.upper.z, 0.0F}};
  }
  Box3f unionOf(std::size_t begin, std::size_t end) const {
    Box3f box;
    for (std::size_t i = begin; i < end; ++i)
      box.extend(m_boxes[m_order[i]]);
    return box;
  }
  double area(const Box3f& b) const { return toBounds(b).halfArea(); }

  void sortBy(int axis, std::size_t begin, std::size_t end) {
    const auto key = [&](std::uint32_t i) { return m_boxes[i].lower[axis] + m_boxes[i].upper[axis]; };
    std::sort(m_order.begin() + static_cast<std::ptrdiff_t>(begin),
              m_order.begin() + static_cast<std::ptrdiff_t>(end),
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  }

  /// Where to cut, with the range ordered accordingly; `end` for a leaf.
  std::size_t bestCut(std::size_t begin, std::size_t end) {
    const std::size_t n = end - begin;
    const double whole = area(unionOf(begin, end));
    double best = n <= kMaxLeafTriangles ? accel::kTriangleCost * static_cast<double>(n) * whole
                                         : std::numeric_limits<double>::infinity();
    std::size_t cut = end;
    int bestAxis = -1;
    std::vector<double> right(n + 1);
    for (int axis = 0; axis < 3; ++axis) {
      sortBy(axis, begin, end);
      Box3f box;
      for (std::size_t i = n; i-- > 1;) {
        box.extend(m_boxes[m_order[begin + i]]);
        right[i] = area(box) * static_cast<double>(n - i);
      }
      box = Box3f();
      for (std::size_t i = 1; i < n; ++i) {
        box.extend(m_boxes[m_order[begin + i - 1]]);
        const double tests = area(box) * static_cast<double>(i) + right[i];
        const double cost = accel::kNodeCost * whole + accel::kTriangleCost * tests;
        if (cost < best) {
          best = cost;
          cut = begin + i;
          bestAxis = axis;
        }
      }
    }
    if (bestAxis >= 0)
      sortBy(bestAxis, begin, end);
    return cut;
  }

  std::span<const Box3f> m_boxes;
  std::vector<std::uint32_t> m_order;
  accel::BinaryBvh m_tree;
};

} // namespace

Bvh buildByExactSweep(std::span<const Box3f> boxes) { return ExactBuilder(boxes).build(); }

} // namespace vkpt::test
