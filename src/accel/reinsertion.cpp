#include "accel/reinsertion.h"

#include "accel/sah_split.h"

#include <algorithm>
#include <utility>

namespace vkpt::accel {

namespace {

constexpr int kRounds = 3;
constexpr double kWorthAnother = 0.998; ///< share of the sum that a round leaves, for another one to be tried
/// Candidates of a round: all in a small tree, a share of a large one.
constexpr std::size_t kMinCandidates = std::size_t{1} << 15U;
constexpr std::size_t kCandidateShare = 16;
/// Nodes that one search looks at: where boxes overlap without end, it would see the whole tree.
constexpr int kMaxLooks = 1000;
/// Gains below this share of the moved node's parent are rounding.
constexpr double kLeastGain = 1e-6;

Bounds together(const Bounds& a, const Bounds& b) {
  Bounds both = a;
  both.extend(b);
  return both;
}

class Reinserter {
public:
  explicit Reinserter(LinkedTree& tree)
      : m_tree(tree), m_nodes(tree.nodes), m_measure(tree.nodes[0].bounds) {}

  void runRound() {
    for (const std::uint32_t node : candidates()) {
      const std::uint32_t parent = m_nodes[node].parent;
      if (node == 0 || parent == 0) // the root stays
        continue;
      const std::uint32_t target = bestPlace(node);
      if (target != kNoNode)
        move(node, target);
    }
  }

private:
  [[nodiscard]] double measure(std::uint32_t node) const { return m_measure(m_nodes[node].bounds); }

  std::vector<std::uint32_t> candidates() {
    std::vector<std::pair<double, std::uint32_t>> all(m_nodes.size());
    for (std::uint32_t i = 0; i < all.size(); ++i)
      all[i] = {-measure(i), i};
    const std::size_t count = std::min(all.size(), std::max(kMinCandidates, all.size() / kCandidateShare));
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(count);
    if (end != all.end())
      std::nth_element(all.begin(), end, all.end());
    std::sort(all.begin(), end);
    std::vector<std::uint32_t> chosen(count);
    std::transform(all.begin(), end, chosen.begin(), [](const auto& c) { return c.second; });
    return chosen;
  }

  /// The node beside which `node` costs least, or none. Upwards from where it is: at each ancestor the
  /// subtree beside the way is searched.
  std::uint32_t bestPlace(std::uint32_t node) {
    const double parentSurface = measure(m_nodes[node].parent);
    Search s{m_nodes[node].bounds, measure(node), kLeastGain * parentSurface, kNoNode, kMaxLooks};
    std::uint32_t ancestor = m_nodes[node].parent;
    std::uint32_t beside = m_tree.sibling(node);
    Bounds rest = m_nodes[beside].bounds; // the ancestor's without the node
    double saved = parentSurface;         // this one goes, those above shrink
    for (;;) {
      search(s, beside, saved);
      if (ancestor == 0 || s.looks <= 0)
        return s.place;
      if (ancestor != m_nodes[node].parent)
        saved += measure(ancestor) - m_measure(rest);
      beside = m_tree.sibling(ancestor);
      rest.extend(m_nodes[beside].bounds);
      ancestor = m_nodes[ancestor].parent;
    }
  }

  struct Search {
    Bounds bounds; ///< of the node to be placed
    double surface;
    double gain; ///< the best so far
    std::uint32_t place;
    int looks; ///< left
  };

  /// Below `top`, where `saved` is what removal and the way down have saved so far; cut where even a new
  /// parent as small as the node would not gain.
  void search(Search& s, std::uint32_t top, double saved) {
    m_open.assign(1, {top, saved});
    while (!m_open.empty() && s.looks-- > 0) {
      const auto [node, left] = m_open.back();
      m_open.pop_back();
      if (left - s.surface <= s.gain)
        continue;
      const double parent = m_measure(together(m_nodes[node].bounds, s.bounds));
      if (left - parent > s.gain) {
        s.gain = left - parent;
        s.place = node;
      }
      const double below = left - (parent - measure(node));
      if (!m_nodes[node].isLeaf() && below - s.surface > s.gain) {
        for (const std::uint32_t c : m_nodes[node].child)
          m_open.emplace_back(c, below);
      }
    }
  }

  /// The node's parent goes with it, and becomes that of `place` too.
  void move(std::uint32_t node, std::uint32_t place) {
    const std::uint32_t parent = m_nodes[node].parent;
    const std::uint32_t left = m_tree.sibling(node);
    const std::uint32_t above = m_nodes[parent].parent;
    replaceChild(above, parent, left);
    refit(above);
    replaceChild(m_nodes[place].parent, place, parent);
    m_nodes[parent].child = {place, node};
    m_nodes[place].parent = parent;
    refit(parent);
  }
  void replaceChild(std::uint32_t parent, std::uint32_t from, std::uint32_t to) {
    auto& child = m_nodes[parent].child;
    child[child[0] == from ? 0 : 1] = to;
    m_nodes[to].parent = parent;
  }
  void refit(std::uint32_t node) {
    for (; node != kNoNode; node = m_nodes[node].parent) {
      LinkedNode& n = m_nodes[node];
      n.bounds = together(m_nodes[n.child[0]].bounds, m_nodes[n.child[1]].bounds);
    }
  }

  LinkedTree& m_tree;
  std::vector<LinkedNode>& m_nodes;
  SurfaceMeasure m_measure;
  std::vector<std::pair<std::uint32_t, double>> m_open;
};

} // namespace

double innerSurface(const LinkedTree& tree) {
  const SurfaceMeasure measure(tree.nodes[0].bounds);
  double sum = 0.0;
  for (const LinkedNode& n : tree.nodes)
    sum += n.isLeaf() ? 0.0 : measure(n.bounds);
  return sum / measure(tree.nodes[0].bounds);
}

void reinsert(LinkedTree& tree) {
  Reinserter reinserter(tree);
  double before = innerSurface(tree);
  for (int round = 0; round < kRounds; ++round) {
    reinserter.runRound();
    const double after = innerSurface(tree);
    if (after > kWorthAnother * before)
      return;
    before = after;
  }
}

} // namespace vkpt::accel
