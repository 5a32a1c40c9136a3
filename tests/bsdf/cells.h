#pragma once
// A grid of cells over the unit square: integrals over them, and counts of samples in them.

#include "bsdf/charts.h"

#include <vector>

namespace vkpt::test {

struct Grid {
  int columns = 16; ///< along u
  int rows = 24;    ///< along v
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  [[nodiscard]] std::size_t cellOf(const Vec2d& position) const;
};

/// Of two functions at once; the error of each cell is about `tolerance`. Adaptive Simpson rule, nested.
std::vector<Vec2d> integrals(const Grid& grid, const std::function<Vec2d(double u, double v)>& f,
                             double tolerance);

} // namespace vkpt::test
