#include "unit/accel/bvh_check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

namespace vkpt::test {

namespace {

Box3f childBox(const BvhNode& n, std::uint32_t i) {
  return {{n.lowerX[i], n.lowerY[i], n.lowerZ[i]}, {n.upperX[i], n.upperY[i], n.upperZ[i]}};
}

/// No triangle of these tests has its box at kFarBox.
bool isAbsent(const BvhNode& n, std::uint32_t i) {
  const Box3f b = childBox(n, i);
  return n.child[i] == child_ref::kAbsent && b.lower == Vec3f(kFarBox) && b.upper == Vec3f(kFarBox);
}

bool same(const Box3f& a, const Box3f& b) { return a.lower == b.lower && a.upper == b.upper; }

/// Walks the tree once, with the stack that the device would have.
class Checker {
public:
  Checker(const Bvh& bvh, std::span<const Box3f> boxes)
      : m_bvh(bvh), m_boxes(boxes), m_nodeSeen(bvh.nodes.size()), m_triangleSeen(boxes.size()),
        m_union(bvh.nodes.size()) {}

  std::string flaw() {
    if (m_bvh.nodes.empty() || m_bvh.triangleOrder.size() != m_boxes.size())
      return "no root, or an order of the wrong length";
    std::vector<Entry> stack{{0, 1}};
    std::size_t highest = 1;
    while (!stack.empty() && m_flaw.empty()) {
      const Entry e = stack.back();
      stack.pop_back();
      visit(e, stack);
      highest = std::max(highest, stack.size());
    }
    if (m_flaw.empty())
      checkWhole(highest);
    return m_flaw;
  }

private:
  struct Entry {
    std::uint32_t node, depth;
  };

  void visit(const Entry& e, std::vector<Entry>& stack) {
    if (m_nodeSeen[e.node])
      return fail("a node is reached twice", e.node);
    m_nodeSeen[e.node] = true;
    m_order.push_back(e.node);
    m_depth = std::max(m_depth, e.depth);
    const BvhNode& n = m_bvh.nodes[e.node];
    std::uint32_t present = 0;
    while (present < kBvhWidth && !isAbsent(n, present))
      ++present;
    for (std::uint32_t i = present; i < kBvhWidth; ++i) {
      if (!isAbsent(n, i))
        return fail("a child stands behind an absent one", e.node);
    }
    if (present < 2 && m_boxes.size() > kMaxLeafTriangles)
      return fail("a node with fewer than two children", e.node);
    for (std::uint32_t i = 0; i < present; ++i) {
      if (child_ref::isLeaf(n.child[i])) {
        checkLeaf(n, i);
      } else if (n.child[i] >= m_bvh.nodes.size()) {
        return fail("a child that is not there", e.node);
      } else {
        stack.push_back({n.child[i], e.depth + 1});
      }
    }
    if (static_cast<std::uint32_t>(std::count(n.unused.begin(), n.unused.end(), 0U)) != 4)
      fail("unused words are not 0", e.node);
  }

  void checkLeaf(const BvhNode& n, std::uint32_t i) {
    const std::uint32_t first = child_ref::first(n.child[i]);
    const std::uint32_t count = child_ref::count(n.child[i]);
    if (count > kMaxLeafTriangles || first + count > m_boxes.size())
      return fail("a leaf too large or outside the order", first);
    Box3f box;
    for (std::uint32_t k = first; k < first + count; ++k) {
      const std::uint32_t t = m_bvh.triangleOrder[k];
      if (t >= m_boxes.size() || m_triangleSeen[t])
        return fail("a triangle twice, or one that is not there", t);
      m_triangleSeen[t] = true;
      box.extend(m_boxes[t]);
    }
    if (!same(box, childBox(n, i)))
      fail("a leaf's box is not the union of its triangles'", first);
  }

  /// Children come after their parents in m_order: from the back, every union is complete before it is used.
  void checkWhole(std::size_t highest) {
    for (auto node = m_order.rbegin(); node != m_order.rend(); ++node) {
      const BvhNode& n = m_bvh.nodes[*node];
      for (std::uint32_t i = 0; i < kBvhWidth && !isAbsent(n, i); ++i) {
        m_union[*node].extend(childBox(n, i));
        if (!child_ref::isLeaf(n.child[i]) && !same(childBox(n, i), m_union[n.child[i]]))
          return fail("a box is not the union of what is below it", *node);
      }
    }
    if (m_order.size() != m_bvh.nodes.size())
      fail("a node is not reached", m_order.size());
    if (std::count(m_triangleSeen.begin(), m_triangleSeen.end(), false) != 0)
      fail("triangles are missing", m_boxes.size());
    if (m_depth != m_bvh.depth)
      fail("the depth is not as stated", m_depth);
    if (highest > m_bvh.stackSize())
      fail("the stack is too small", highest);
  }

  void fail(const std::string& what, std::size_t where) {
    if (m_flaw.empty())
      m_flaw = what + " (" + std::to_string(where) + ")";
  }

  const Bvh& m_bvh;
  std::span<const Box3f> m_boxes;
  std::vector<bool> m_nodeSeen, m_triangleSeen;
  std::vector<Box3f> m_union;
  std::vector<std::uint32_t> m_order;
  std::uint32_t m_depth = 0;
  std::string m_flaw;
};

/// Möller and Trumbore 1997; both sides.
std::optional<double> triangleHit(const Triangle& triangle, const Ray& ray) {
  const Vec3d a = triangle[0];
  const Vec3d ab = Vec3d(triangle[1]) - a;
  const Vec3d ac = Vec3d(triangle[2]) - a;
  const Vec3d p = glm::cross(ray.direction, ac);
  const double det = glm::dot(ab, p);
  if (det == 0.0)
    return std::nullopt;
  const Vec3d s = ray.origin - a;
  const double u = glm::dot(s, p) / det;
  const Vec3d q = glm::cross(s, ab);
  const double v = glm::dot(ray.direction, q) / det;
  const double t = glm::dot(ac, q) / det;
  if (u < 0.0 || v < 0.0 || u + v > 1.0 || t <= 0.0 || t > ray.tMax)
    return std::nullopt;
  return t;
}

/// Slabs, widened by a few units in the last place of double: boxes are float, the hits are rounded.
bool meets(const Box3f& box, const Ray& ray, double tMax) {
  double from = 0.0;
  double to = tMax;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / ray.direction[axis];
    const double t0 = (static_cast<double>(box.lower[axis]) - ray.origin[axis]) * inverse;
    const double t1 = (static_cast<double>(box.upper[axis]) - ray.origin[axis]) * inverse;
    constexpr double kWiden = 1e-13;
    from = std::max(from, std::min(t0, t1) - kWiden * std::abs(t0));
    to = std::min(to, std::max(t0, t1) + kWiden * std::abs(t1));
  }
  return from <= to;
}

void tryTriangle(const Mesh& mesh, std::uint32_t triangle, const Ray& ray, Hit& best) {
  const std::optional<double> t = triangleHit(mesh[triangle], ray);
  if (t && (*t < best.t || (*t == best.t && triangle < best.triangle)))
    best = {*t, triangle};
}

/// Calls `leaf(first, count)`, which returns how far to look from then on, for each leaf whose box is met.
template<class Leaf>
void traverse(const Bvh& bvh, const Ray& ray, const Leaf& leaf) {
  std::vector<std::uint32_t> stack{0};
  double tMax = ray.tMax;
  while (!stack.empty()) {
    const BvhNode& n = bvh.nodes[stack.back()];
    stack.pop_back();
    for (std::uint32_t i = 0; i < kBvhWidth; ++i) {
      if (!meets(childBox(n, i), ray, tMax))
        continue;
      if (child_ref::isLeaf(n.child[i]))
        tMax = std::min(tMax, leaf(child_ref::first(n.child[i]), child_ref::count(n.child[i])));
      else
        stack.push_back(n.child[i]);
    }
  }
}

} // namespace

std::string flawOf(const Bvh& bvh, std::span<const Box3f> boxes) { return Checker(bvh, boxes).flaw(); }

double expectedCost(const Bvh& bvh, double nodeCost) {
  Box3d root;
  double sum = 0.0;
  for (const BvhNode& n : bvh.nodes) {
    for (std::uint32_t i = 0; i < kBvhWidth && !isAbsent(n, i); ++i) {
      const Box3f b = childBox(n, i);
      const Box3d box{b.lower, b.upper};
      const std::uint32_t c = n.child[i];
      sum += box.halfArea() * (child_ref::isLeaf(c) ? child_ref::count(c) : nodeCost);
      if (&n == &bvh.nodes.front())
        root.extend(box);
    }
  }
  return nodeCost + sum / root.halfArea();
}

std::array<std::size_t, kMaxLeafTriangles> leafSizes(const Bvh& bvh) {
  std::array<std::size_t, kMaxLeafTriangles> sizes{};
  for (const BvhNode& n : bvh.nodes) {
    for (std::uint32_t i = 0; i < kBvhWidth && !isAbsent(n, i); ++i) {
      if (child_ref::isLeaf(n.child[i]))
        ++sizes.at(child_ref::count(n.child[i]) - 1);
    }
  }
  return sizes;
}

Hit bruteForceHit(const Mesh& mesh, const Ray& ray) {
  Hit best;
  for (std::uint32_t i = 0; i < mesh.size(); ++i)
    tryTriangle(mesh, i, ray, best);
  return best;
}

Hit treeHit(const Bvh& bvh, const Mesh& mesh, const Ray& ray) {
  Hit best;
  traverse(bvh, ray, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t k = first; k < first + count && k < bvh.triangleOrder.size(); ++k)
      tryTriangle(mesh, bvh.triangleOrder[k], ray, best);
    return best.t;
  });
  return best;
}

std::size_t trianglesTested(const Bvh& bvh, const Ray& ray) {
  std::size_t tested = 0;
  traverse(bvh, ray, [&](std::uint32_t, std::uint32_t count) {
    tested += count;
    return ray.tMax;
  });
  return tested;
}

} // namespace vkpt::test
