#include "accel/sah_split.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vkpt::accel {

namespace {

/// Small ranges gain nothing from narrow bins, and clearing and sweeping the bins is what they cost.
std::uint32_t binCount(std::size_t primitives) { return primitives < 256 ? 16 : kMaxBins; }

} // namespace

BinMap::BinMap(const Bounds& centroids, std::size_t primitives) : m_bins(binCount(primitives)) {
  for (int axis = 0; axis < 3; ++axis) {
    const float scale = static_cast<float>(m_bins) / (centroids.upper[axis] - centroids.lower[axis]);
    m_origin[axis] = centroids.lower[axis];
    m_scale[axis] = std::isfinite(scale) ? scale : 0.0F; // no extent, or one too small to divide by
  }
}

BinGrid::BinGrid(std::uint32_t bins) : m_bins(bins) {
  for (int axis = 0; axis < 3; ++axis) {
    std::fill_n(m_box[axis].begin(), bins, Bounds::none());
    std::fill_n(m_count[axis].begin(), bins, 0U);
  }
}

void BinGrid::add(std::span<const Primitive> primitives, const BinMap& map) {
  for (const Primitive& p : primitives) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t b = map.bin(p, axis);
      m_box[axis][b].extend(p);
      ++m_count[axis][b];
    }
  }
}

void BinGrid::add(const BinGrid& other) {
  for (int axis = 0; axis < 3; ++axis) {
    for (std::uint32_t b = 0; b < m_bins; ++b) {
      m_box[axis][b].extend(other.m_box[axis][b]);
      m_count[axis][b] += other.m_count[axis][b];
    }
  }
}

std::uint32_t BinGrid::countBelow(int axis, std::uint32_t end) const {
  return std::accumulate(m_count[axis].begin(), m_count[axis].begin() + end, 0U);
}

std::optional<Split> findSplit(const BinGrid& grid, std::uint32_t bins, const Bounds& whole,
                               std::uint64_t maxSide) {
  const SurfaceMeasure measure(whole);
  std::optional<Split> best;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<double, kMaxBins> rightCost;
    std::array<std::uint32_t, kMaxBins> rightCount;
    Bounds box = Bounds::none();
    std::uint32_t count = 0;
    for (std::uint32_t b = bins - 1; b > 0; --b) {
      box.extend(grid.box(axis, b));
      count += grid.count(axis, b);
      rightCount[b] = count;
      rightCost[b] = count == 0 ? 0.0 : measure(box) * count;
    }
    box = Bounds::none();
    count = 0;
    for (std::uint32_t b = 1; b < bins; ++b) { // the cut below bin b
      box.extend(grid.box(axis, b - 1));
      count += grid.count(axis, b - 1);
      if (count == 0 || rightCount[b] == 0 || std::max(count, rightCount[b]) > maxSide)
        continue;
      const double cost = kNodeCost * measure(whole) + kTriangleCost * (measure(box) * count + rightCost[b]);
      if (!best || cost < best->cost)
        best = Split{axis, b, cost};
    }
  }
  return best;
}

} // namespace vkpt::accel
