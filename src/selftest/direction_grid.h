#pragma once
// Directions in cells of equal solid angle: a grid over cos(theta) and phi.

#include "core/math.h"
#include "selftest/hypothesis.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace vkpt {

class DirectionGrid {
public:
  /// `resolution` rows of cos(theta) from -1 to 1, each of twice as many cells of phi.
  explicit DirectionGrid(int resolution) : m_rows(resolution), m_columns(2 * resolution) {}

  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(m_rows) * static_cast<std::size_t>(m_columns);
  }
  /// Of a unit vector.
  [[nodiscard]] std::size_t cellOf(const Vec3d& direction) const;
  /// The integral over each cell of a density over solid angle, to a relative 1e-5 or an absolute 1e-8; less
  /// at edges of the density, and where a peak is narrower than a fortieth of a cell.
  [[nodiscard]] std::vector<double> integrate(const std::function<double(const Vec3d&)>& density) const;

private:
  int m_rows;
  int m_columns;
};

/// Sample number `index`; none where the sampling gave up.
using SampleDirection = std::function<std::optional<Vec3d>(std::uint32_t index)>;
using DirectionDensity = std::function<double(const Vec3d&)>;

struct DirectionCounts {
  std::vector<CellCount> cells; ///< the grid's; the last one holds the samples that gave up
  std::uint32_t impossible = 0; ///< samples that went where the density is not above 0
};

/// Where `samples` samples go, and where they should by their density. What the density's integral leaves of
/// 1 should give up.
DirectionCounts countDirections(const DirectionGrid& grid, const SampleDirection& sample,
                                const DirectionDensity& density, std::uint32_t samples);

} // namespace vkpt
