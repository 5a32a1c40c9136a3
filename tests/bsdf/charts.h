#pragma once
// Maps of the unit square to directions, fine where a lobe is, so that equal cells of the square resolve it.

#include "core/math.h"

#include <functional>
#include <optional>

namespace vkpt::test {

using Vec2d = glm::dvec2;

struct Chart {
  /// Unit; empty where the square leads nowhere, such as beyond total reflection.
  std::function<std::optional<Vec3d>(double u, double v)> direction;
  /// Its inverse; empty for directions that are not in the chart.
  std::function<std::optional<Vec2d>(const Vec3d&)> locate;

  /// Steradians a unit of the square's area: central differences, so that no formula of the library is used.
  [[nodiscard]] double jacobian(double u, double v) const;
};

/// Directions on n's side, by their polar angle about `axis`, half of them in angles up to about `width`.
Chart polarChart(const Vec3d& axis, const Vec3d& n, double width);

/// Directions on n's side by the slope of the facet that mirrors wo there, half of them below alpha.
Chart reflectionChart(const Vec3d& wo, const Vec3d& n, double alpha);

/// Directions on the other side by the slope of the facet that refracts wo there; eta: index there over the
/// index on wo's side.
Chart refractionChart(const Vec3d& wo, const Vec3d& n, double alpha, double eta);

} // namespace vkpt::test
