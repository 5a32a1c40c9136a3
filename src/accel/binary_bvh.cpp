#include "accel/binary_bvh.h"

#include "accel/sah_split.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

namespace vkpt::accel {

namespace {

/// Ranges above this size are split by all threads together, the rest are tasks of one thread each.
constexpr std::size_t kTaskPrimitives = std::size_t{1} << 15U;
constexpr std::size_t kMaxChunks = 64;
constexpr std::uint32_t kNoParent = ~0U;

/// Part of a range that one thread reads at a time. The division depends on the size alone, never on the
/// number of threads: so does the result, down to the sign of a zero.
std::size_t chunkCount(std::size_t primitives) {
  return primitives <= kTaskPrimitives ? 1 : std::min(kMaxChunks, primitives / (kTaskPrimitives / 4));
}

/// Primitives [begin, end) that become a child of `parent`, with `levels` of inner nodes left for them.
struct Range {
  std::uint32_t begin, end;
  Extent extent;
  std::uint32_t levels;
  std::uint32_t parent, side;
  [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

struct Halves {
  std::uint32_t middle;
  std::array<Extent, 2> extent;
};

class BinaryBuilder {
public:
  BinaryBuilder(std::span<Primitive> primitives, Leaves leaves, Workers& workers)
      : m_primitives(primitives), m_leaves(leaves),
        m_scratch(std::make_unique_for_overwrite<Primitive[]>(primitives.size())), m_workers(workers) {
    m_tree.nodes =
        std::make_unique_for_overwrite<BinaryNode[]>(primitives.size()); // pages unused stay unmapped
  }
  BinaryBvh build(std::uint32_t levels);

private:
  std::span<Primitive> chunk(const Range& r, std::size_t i, std::size_t chunks) const;
  template<class Body>
  void forChunks(std::size_t chunks, const Body& body);
  Extent measure(std::uint32_t begin, std::uint32_t end);
  bool divide(const Range& r, std::array<Range, 2>& children);
  std::optional<Halves> splitBySurface(const Range& r);
  Halves partition(const Range& r, const Split& split, const BinMap& map, std::span<const BinGrid> grids);
  Halves splitInMiddle(const Range& r);
  void buildSubtree(const Range& root);
  void attach(const Range& r, std::uint32_t ref);

  std::span<Primitive> m_primitives;
  Leaves m_leaves;
  std::unique_ptr<Primitive[]> m_scratch;
  Workers& m_workers;
  BinaryBvh m_tree;
  std::atomic<std::uint32_t> m_nodeCount{0};
};

std::span<Primitive> BinaryBuilder::chunk(const Range& r, std::size_t i, std::size_t chunks) const {
  const std::size_t from = r.size() * i / chunks;
  const std::size_t to = r.size() * (i + 1) / chunks;
  return m_primitives.subspan(r.begin + from, to - from);
}

template<class Body>
void BinaryBuilder::forChunks(std::size_t chunks, const Body& body) {
  if (chunks == 1)
    body(std::size_t{0});
  else
    m_workers.forEach(chunks, body);
}

Extent BinaryBuilder::measure(std::uint32_t begin, std::uint32_t end) {
  const Range r{begin, end, {}, 0, 0, 0};
  const std::size_t chunks = chunkCount(r.size());
  std::vector<Extent> parts(chunks, Extent::none());
  forChunks(chunks, [&](std::size_t i) {
    for (const Primitive& p : chunk(r, i, chunks))
      parts[i].extend(p);
  });
  for (std::size_t i = 1; i < chunks; ++i)
    parts[0].extend(parts[i]);
  return parts[0];
}

/// Wald 2007. None where the range should be a leaf, or has to be cut in the middle.
std::optional<Halves> BinaryBuilder::splitBySurface(const Range& r) {
  const BinMap map(r.extent.centroids, r.size());
  const std::size_t chunks = chunkCount(r.size());
  BinGrid first(map.bins());
  std::vector<BinGrid> grids; // of more than one chunk: each its own
  if (chunks == 1) {
    first.add(chunk(r, 0, 1), map);
  } else {
    grids.assign(chunks, first);
    forChunks(chunks, [&](std::size_t i) { grids[i].add(chunk(r, i, chunks), map); });
    for (const BinGrid& g : grids)
      first.add(g);
  }
  const std::uint64_t maxSide = std::uint64_t{kMaxLeafTriangles} << std::min(r.levels - 1U, 32U);
  const std::optional<Split> split = findSplit(first, map.bins(), r.extent.bounds, maxSide);
  if (!split)
    return std::nullopt;
  const double leafCost = kTriangleCost * r.size() * SurfaceMeasure(r.extent.bounds)(r.extent.bounds);
  if (m_leaves == Leaves::Cheapest && r.size() <= kMaxLeafTriangles && leafCost <= split->cost)
    return std::nullopt;
  return partition(r, *split, map, chunks == 1 ? std::span<const BinGrid>(&first, 1) : grids);
}

/// Stable: left of the cut first, within each side as before.
Halves BinaryBuilder::partition(const Range& r, const Split& split, const BinMap& map,
                                std::span<const BinGrid> grids) {
  const std::size_t chunks = grids.size();
  std::array<std::array<std::uint32_t, kMaxChunks>, 2> offset; // where each chunk's left and right ones go
  std::uint32_t end = 0;
  for (int side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < chunks; ++i) {
      const std::uint32_t left = grids[i].countBelow(split.axis, split.bin);
      const auto size = static_cast<std::uint32_t>(chunk(r, i, chunks).size());
      offset[side][i] = end;
      end += side == 0 ? left : size - left;
    }
  }
  std::array<std::array<Extent, 2>, kMaxChunks> extents;
  Primitive* const scratch = m_scratch.get() + r.begin;
  forChunks(chunks, [&](std::size_t i) {
    std::array<std::uint32_t, 2> next{offset[0][i], offset[1][i]};
    std::array<Extent, 2> extent{Extent::none(), Extent::none()};
    for (const Primitive& p : chunk(r, i, chunks)) {
      const auto side = static_cast<std::size_t>(map.bin(p, split.axis) >= split.bin);
      scratch[next[side]++] = p;
      extent[side].extend(p);
    }
    extents[i] = extent;
  });
  forChunks(chunks, [&](std::size_t i) {
    const std::span<Primitive> to = chunk(r, i, chunks);
    std::copy_n(m_scratch.get() + (to.data() - m_primitives.data()), to.size(), to.data());
  });
  Halves h{r.begin + offset[1][0], extents[0]};
  for (std::size_t i = 1; i < chunks; ++i) {
    h.extent[0].extend(extents[i][0]);
    h.extent[1].extend(extents[i][1]);
  }
  return h;
}

/// As many primitives on one side as on the other: by centroid along the widest axis, or as they stand where
/// all centroids coincide.
Halves BinaryBuilder::splitInMiddle(const Range& r) {
  const Bounds& c = r.extent.centroids;
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    axis = c.extent(a) > c.extent(axis) ? a : axis;
  const std::uint32_t middle = r.begin + (r.size() + 1) / 2;
  if (c.extent(axis) > 0.0) {
    std::nth_element(m_primitives.begin() + r.begin, m_primitives.begin() + middle,
                     m_primitives.begin() + r.end, [axis](const Primitive& a, const Primitive& b) {
                       return std::pair(a.centroid(axis), a.index()) < std::pair(b.centroid(axis), b.index());
                     });
  }
  return {middle, {measure(r.begin, middle), measure(middle, r.end)}};
}

/// Makes the range a leaf and returns false, or an inner node and returns true with what is to become of it.
bool BinaryBuilder::divide(const Range& r, std::array<Range, 2>& children) {
  std::optional<Halves> halves;
  if (r.size() > 1 && r.levels > 0)
    halves = splitBySurface(r);
  const std::uint32_t most = m_leaves == Leaves::Single && r.levels > 0 ? 1 : kMaxLeafTriangles;
  if (!halves && r.size() <= most) {
    attach(r, child_ref::leaf(r.begin, r.size()));
    return false;
  }
  if (!halves)
    halves = splitInMiddle(r);
  const std::uint32_t node = m_nodeCount.fetch_add(1, std::memory_order_relaxed);
  m_tree.nodes[node].bounds = {halves->extent[0].bounds, halves->extent[1].bounds};
  attach(r, node);
  children[0] = {r.begin, halves->middle, halves->extent[0], r.levels - 1, node, 0};
  children[1] = {halves->middle, r.end, halves->extent[1], r.levels - 1, node, 1};
  return true;
}

void BinaryBuilder::attach(const Range& r, std::uint32_t ref) {
  if (r.parent == kNoParent)
    m_tree.root = ref;
  else
    m_tree.nodes[r.parent].child[r.side] = ref;
}

void BinaryBuilder::buildSubtree(const Range& root) {
  std::vector<Range> open{root}; // at most one a level, and the one at hand
  std::array<Range, 2> children;
  while (!open.empty()) {
    const Range r = open.back();
    open.pop_back();
    if (divide(r, children))
      open.insert(open.end(), children.rbegin(), children.rend());
  }
}

BinaryBvh BinaryBuilder::build(std::uint32_t levels) {
  const auto n = static_cast<std::uint32_t>(m_primitives.size());
  const Extent whole = measure(0, n);
  m_tree.bounds = whole.bounds;
  std::vector<Range> open{{0, n, whole, levels, kNoParent, 0}};
  std::vector<Range> tasks;
  std::array<Range, 2> children;
  while (!open.empty()) {
    const Range r = open.back();
    open.pop_back();
    if (r.size() <= kTaskPrimitives)
      tasks.push_back(r);
    else if (divide(r, children))
      open.insert(open.end(), children.begin(), children.end());
  }
  // The largest first, so that no thread begins a long one when the others have run out.
  std::sort(tasks.begin(), tasks.end(), [](const Range& a, const Range& b) { return a.size() > b.size(); });
  m_workers.forEach(tasks.size(), [&](std::size_t i) { buildSubtree(tasks[i]); });
  m_tree.nodeCount = m_nodeCount;
  return std::move(m_tree);
}

} // namespace

std::uint32_t balancedLevels(std::size_t primitives) {
  const std::size_t leaves = (primitives + kMaxLeafTriangles - 1) / kMaxLeafTriangles;
  return leaves <= 1 ? 0 : static_cast<std::uint32_t>(std::bit_width(leaves - 1));
}

BinaryBvh buildBinaryBvh(std::span<Primitive> primitives, std::uint32_t levels, Leaves leaves,
                         Workers& workers) {
  assert(!primitives.empty() && levels >= balancedLevels(primitives.size()));
  BinaryBvh tree = BinaryBuilder(primitives, leaves, workers).build(levels);
  setHeights(tree);
  return tree;
}

void setHeights(BinaryBvh& tree) {
  for (std::size_t i = tree.nodeCount; i-- > 0;) { // children first: their indices are larger
    std::uint32_t below = 0;
    for (const std::uint32_t c : tree.nodes[i].child)
      below = std::max(below, child_ref::isLeaf(c) ? 0U : tree.nodes[c].height);
    tree.nodes[i].height = below + 1;
  }
}

} // namespace vkpt::accel
