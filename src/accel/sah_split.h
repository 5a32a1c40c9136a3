#pragma once
// The surface area heuristic: where to cut a range of primitives in two, judged from centroid bins.

#include "accel/primitive.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace vkpt::accel {

/// Cost of visiting one node of the binary tree, for the cuts, and of testing one triangle. Measured on
/// lavapipe, both Cornell boxes: 0.6 to 1.5 are equal, 2.0 is 4 % slower, 4.0 a quarter.
inline constexpr double kNodeCost = 1.5;
inline constexpr double kTriangleCost = 1.0;
/// Cost of visiting a four-wide node: 0.6 to 2.0 are equally fast on the Cornell box, 2.5 is slower. The less
/// it is, the fewer triangles are tested, and the less it matters that their test is watertight
/// (tests/bench/price.sh).
inline constexpr double kWideNodeCost = 1.0;

inline constexpr std::uint32_t kMaxBins = 32;

/// Maps centroids to bins of equal width on the three axes, within the box of the centroids.
class BinMap {
public:
  BinMap(const Bounds& centroids, std::size_t primitives);
  [[nodiscard]] std::uint32_t bins() const { return m_bins; }
  /// An axis along which all centroids coincide has everything in bin 0.
  [[nodiscard]] std::uint32_t bin(const Primitive& p, int axis) const {
    const auto b = static_cast<std::uint32_t>(
        static_cast<std::int32_t>((p.centroid(axis) - m_origin[axis]) * m_scale[axis]));
    return b < m_bins ? b : m_bins - 1;
  }

private:
  std::uint32_t m_bins;
  std::array<float, 3> m_origin{}, m_scale{};
};

/// Box and number of the primitives of each bin.
class BinGrid {
public:
  explicit BinGrid(std::uint32_t bins);
  void add(std::span<const Primitive> primitives, const BinMap& map);
  void add(const BinGrid& other);
  [[nodiscard]] const Bounds& box(int axis, std::uint32_t bin) const { return m_box[axis][bin]; }
  [[nodiscard]] std::uint32_t count(int axis, std::uint32_t bin) const { return m_count[axis][bin]; }
  /// Primitives in the bins below `end`.
  [[nodiscard]] std::uint32_t countBelow(int axis, std::uint32_t end) const;

private:
  std::uint32_t m_bins;
  std::array<std::array<Bounds, kMaxBins>, 3> m_box;
  std::array<std::array<std::uint32_t, kMaxBins>, 3> m_count;
};

/// A cut between bins: those below `bin` go left.
struct Split {
  int axis;
  std::uint32_t bin;
  double cost; ///< kNodeCost and the expected triangle tests, times the measure of the whole
};

/// Surface measure that weighs the two sides of a cut of `whole`: half the area, or the sum of the edges
/// where the whole is so thin that every area in it is 0.
class SurfaceMeasure {
public:
  explicit SurfaceMeasure(const Bounds& whole) : m_useLength(!(whole.halfArea() > 0.0)) {}
  double operator()(const Bounds& b) const { return m_useLength ? b.length() : b.halfArea(); }

private:
  bool m_useLength;
};

/// The cheapest cut that leaves at most `maxSide` primitives on either side; none where no bins can be parted
/// so.
std::optional<Split> findSplit(const BinGrid& grid, std::uint32_t bins, const Bounds& whole,
                               std::uint64_t maxSide);

} // namespace vkpt::accel
