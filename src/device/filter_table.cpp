#include "device/filter_table.h"

#include "core/error.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/glm.hpp>

namespace vkpt {
namespace {

namespace library {
using Float = double;
#include "shared/language.h"

/// The filters of the shader library.
class Filter {
public:
  Filter(uint shape, const shared::vec4& s) : kFilterShape(shape), m_shape(s.x, s.y, s.z, s.w) {}
  uint kFilterShape;
  static constexpr uint kFilterTent = shared::kFilterTent;
  static constexpr uint kFilterGaussian = shared::kFilterGaussian;
  static constexpr uint kFilterMitchell = shared::kFilterMitchell;
  static constexpr uint kFilterBins = shared::kFilterBins;
  [[nodiscard]] Vec4 filterShape() const { return m_shape; }
  [[nodiscard]] static Float filterEdge(uint /*i*/) { return 0.0; } // the table is not there yet

#include "lib/filter.glsl"

private:
  Vec4 m_shape;
};

#undef INOUT
#undef OUT
#undef precise
#undef CONSTANT
} // namespace library

/// The integral of the filter's shape from -radius to radius.
double integral(const PixelFilter& f) {
  const double r = f.radius;
  switch (f.shape) {
  case PixelFilter::Shape::Box:
    return 2.0 * r;
  case PixelFilter::Shape::Tent:
    return r * r;
  case PixelFilter::Shape::Gaussian: {
    const double bell =
        f.stddev * std::sqrt(2.0 * std::numbers::pi) * std::erf(r / (f.stddev * std::numbers::sqrt2));
    return bell - 2.0 * r * std::exp(-0.5 * r * r / (f.stddev * f.stddev));
  }
  case PixelFilter::Shape::Mitchell:
    return 6.0 * 0.5 * r; // six times a function whose translates add up to 1
  }
  return 1.0;
}

shared::vec4 shapeOf(const PixelFilter& f) {
  const auto number = [](double x) { return static_cast<float>(x); };
  shared::vec4 shape{number(f.radius), number(1.0 / integral(f)), 0.0F, 0.0F};
  if (f.shape == PixelFilter::Shape::Gaussian) {
    const double factor = 0.5 / (f.stddev * f.stddev);
    shape.z = number(factor);
    shape.w = number(std::exp(-f.radius * f.radius * factor));
  }
  if (f.shape == PixelFilter::Shape::Mitchell) {
    shape.z = number(f.b);
    shape.w = number(f.c);
  }
  return shape;
}

} // namespace

bool isPixelBox(const PixelFilter& filter) {
  return filter.shape == PixelFilter::Shape::Box && filter.radius == 0.5;
}

void setFilter(shared::FrameConstants& constants, const PixelFilter& f) {
  if (!(f.radius > 0.0 && f.stddev > 0.0 && f.radius <= 64.0)) {
    throw UsageError(
        fmt::format("a filter of radius {} and stddev {}; give a radius above 0, at most 64, and a "
                    "stddev above 0",
                    f.radius, f.stddev));
  }
  constants.filterShape = shapeOf(f);
  library::Filter filter(static_cast<std::uint32_t>(f.shape), constants.filterShape);
  constexpr std::size_t kCells =
      16384; // fine enough that edges are where they should be to a thousandth of a bin
  std::vector<double> sums(kCells + 1);
  const double cell = 2.0 * f.radius / kCells;
  for (std::size_t i = 0; i < kCells; ++i)
    sums[i + 1] = sums[i] + std::abs(filter.filterValue(-f.radius + cell * (static_cast<double>(i) + 0.5)));
  std::size_t at = 0;
  for (std::uint32_t edge = 0; edge <= shared::kFilterBins; ++edge) {
    const double target = sums.back() * edge / shared::kFilterBins;
    while (at + 1 < kCells && sums[at + 1] < target)
      ++at;
    const double width = sums[at + 1] - sums[at];
    const double within = width > 0.0 ? (target - sums[at]) / width : 0.0;
    const double x =
        edge == shared::kFilterBins ? f.radius : -f.radius + cell * (static_cast<double>(at) + within);
    shared::vec4& group = constants.filterEdges[edge / 4U];
    (&group.x)[edge % 4U] = static_cast<float>(edge == 0 ? -f.radius : x);
  }
}

} // namespace vkpt
