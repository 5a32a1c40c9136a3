// Moved subtrees, and the cheapest of all collapses.

#include "accel/collapse.h"
#include "accel/optimal_collapse.h"
#include "accel/reinsertion.h"
#include "accel/sah_split.h"
#include "unit/accel/bvh_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

struct BinaryTree {
  std::vector<Box3f> boxes;
  std::vector<accel::Primitive> primitives;
  accel::BinaryBvh tree;

  BinaryTree(const Mesh& mesh, accel::Leaves leaves, std::uint32_t levels) : boxes(boxesOf(mesh)) {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const Box3f& b = boxes[i];
      accel::Primitive& p = primitives.emplace_back();
      p.lower = {b.lower.x, b.lower.y, b.lower.z, 0.0F};
      p.upper = {b.upper.x, b.upper.y, b.upper.z, 0.0F};
      p.setIndex(i);
    }
    accel::Workers workers(1);
    tree = accel::buildBinaryBvh(primitives, levels, leaves, workers);
  }
};

/// Large and small triangles among each other: cuts alone leave much to be moved.
Mesh mixed(std::size_t count) {
  return together(soup(count, 0.3F, "large among small"), soup(count, 0.01F, "small among large"));
}

TEST(Reinsertion, NeverRaisesTheSurface) {
  for (const NamedMesh& m : allKinds()) {
    const BinaryTree b(m.mesh, accel::Leaves::Single, 128);
    accel::LinkedTree tree(b.tree);
    const double before = accel::innerSurface(tree);
    accel::reinsert(tree);
    EXPECT_LE(accel::innerSurface(tree), before * (1.0 + 1e-9)) << m.name;
    EXPECT_EQ(flawOf(accel::collapseOptimally(tree, b.primitives), b.boxes), "") << m.name;
  }
}

/// The bounds are choices: a third of what is gained today has to be left.
TEST(Reinsertion, LowersTheSurfaceWhereCutsWereBad) {
  const Mesh mesh = mixed(2000);
  const BinaryTree cut(mesh, accel::Leaves::Single, 128);
  accel::LinkedTree tree(cut.tree);
  const double before = accel::innerSurface(tree);
  accel::reinsert(tree);
  testing::Test::RecordProperty("ratio", std::to_string(accel::innerSurface(tree) / before));
  EXPECT_LE(accel::innerSurface(tree), 0.98 * before);
}

/// Least cost of a node's subtree as one child, by trying every set of up to four nodes below it.
class Exhaustive {
public:
  explicit Exhaustive(const accel::LinkedTree& tree) : m_tree(tree) {}

  double node(std::uint32_t i) const {
    const auto& c = m_tree.nodes[i].child;
    return accel::kWideNodeCost * m_tree.nodes[i].bounds.halfArea() + open({c[0], c[1]});
  }

private:
  std::uint32_t count(std::uint32_t i) const {
    const accel::LinkedNode& n = m_tree.nodes[i];
    return n.isLeaf() ? n.count : count(n.child[0]) + count(n.child[1]);
  }
  double one(std::uint32_t i) const {
    double best = count(i) <= kMaxLeafTriangles
                      ? accel::kTriangleCost * m_tree.nodes[i].bounds.halfArea() * count(i)
                      : std::numeric_limits<double>::infinity();
    return m_tree.nodes[i].isLeaf() ? best : std::min(best, node(i));
  }
  double open(const std::vector<std::uint32_t>& children) const {
    double best = 0.0;
    for (const std::uint32_t c : children)
      best += one(c);
    for (std::size_t i = 0; i < children.size() && children.size() < kBvhWidth; ++i) {
      const accel::LinkedNode& n = m_tree.nodes[children[i]];
      if (n.isLeaf())
        continue;
      std::vector<std::uint32_t> more = children;
      more[i] = n.child[0];
      more.push_back(n.child[1]);
      best = std::min(best, open(more));
    }
    return best;
  }
  const accel::LinkedTree& m_tree;
};

TEST(OptimalCollapse, IsTheCheapestOfAll) {
  for (const std::size_t n : {5U, 8U, 13U, 21U}) {
    for (const Mesh& mesh : {mixed(n), soup(n, 0.02F, "sparse"), waves(static_cast<std::uint32_t>(n / 4))}) {
      const BinaryTree b(mesh, accel::Leaves::Single, 128);
      const accel::LinkedTree tree(b.tree);
      const double best = Exhaustive(tree).node(0) / tree.nodes[0].bounds.halfArea();
      const Bvh bvh = accel::collapseOptimally(tree, b.primitives);
      ASSERT_EQ(flawOf(bvh, b.boxes), "");
      // Costs are summed in float: an ulp for each of the nodes on the way, and it may choose by them.
      EXPECT_NEAR(expectedCost(bvh, accel::kWideNodeCost), best, 1e-5 * best) << n;
    }
  }
}

TEST(OptimalCollapse, CostsNoMoreThanTheGreedyOne) {
  for (const Mesh& mesh : {mixed(3000), waves(60), soup(5000, 0.05F, "greedy")}) {
    BinaryTree b(mesh, accel::Leaves::Cheapest, 96);
    const Bvh best = accel::collapseOptimally(accel::LinkedTree(b.tree), b.primitives);
    const Bvh greedy = accel::collapse(b.tree, 48);
    EXPECT_LE(expectedCost(best, accel::kWideNodeCost),
              expectedCost(greedy, accel::kWideNodeCost) * (1.0 + 1e-5));
  }
}

/// All of it together against the same cuts without.
TEST(BvhQuality, IsBetterThanCutsAlone) {
  for (const Mesh& mesh : {mixed(5000), waves(150)}) {
    const BinaryTree b(mesh, accel::Leaves::Cheapest, 96);
    const double cuts = expectedCost(accel::collapse(b.tree, 48), accel::kWideNodeCost);
    EXPECT_LE(expectedCost(buildBvh(b.boxes), accel::kWideNodeCost), 0.98 * cuts);
  }
}

} // namespace
} // namespace vkpt::test
