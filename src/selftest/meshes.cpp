#include "selftest/meshes.h"

#include "core/hash.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::selftest {

Vec3d RoughSphere::vertex(int row, int column) const {
  const bool pole = row == 0 || row == rows;
  const int j = pole ? 0 : column % columns;
  constexpr double kTwoTo64 = 18446744073709551616.0;
  const double u = static_cast<double>(hashText(fmt::format("{} {}", row, j))) / kTwoTo64;
  const double theta = std::numbers::pi * row / rows;
  const double phi = 2.0 * std::numbers::pi * j / columns;
  return (0.7 + 0.6 * u) *
         Vec3d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
}

void RoughSphere::addTo(SceneBuilder& builder, const Material& material) const {
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const Vec3d a = vertex(i, j);
      const Vec3d b = vertex(i + 1, j);
      const Vec3d c = vertex(i + 1, j + 1);
      const Vec3d d = vertex(i, j + 1);
      if (i + 1 < rows)
        builder.triangle(a, b, c, material);
      if (i > 0)
        builder.triangle(a, c, d, material);
    }
  }
}

void addConcentric(SceneBuilder& builder, int count, const Material& material) {
  for (int i = 0; i < count; ++i) {
    const double r = 1.0 + i / static_cast<double>(count);
    builder.triangle({-r, -r, 0.0}, {r, -r, 0.0}, {0.0, r, 0.0}, material);
  }
}

void addSliverFan(SceneBuilder& builder, int count, double radius, const Material& material) {
  const auto rim = [&](int i) {
    const double phi = 2.0 * std::numbers::pi * (i % count) / count;
    return radius * Vec3d(std::cos(phi), std::sin(phi), 0.0);
  };
  for (int i = 0; i < count; ++i)
    builder.triangle(Vec3d(0.0), rim(i), rim(i + 1), material);
}

} // namespace vkpt::selftest
