#include "selftest/direction_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vkpt {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

struct Rectangle {
  double x0, x1, y0, y1;
};

/// Integrates over rectangles, which it quarters until the quarters say what the whole said.
class Cubature {
public:
  using Integrand = std::function<double(double, double)>;
  explicit Cubature(const Integrand& f) : m_f(f) {}

  [[nodiscard]] double integrate(const Rectangle& r) const { return refine(r, byRule(r), 0); }

private:
  static constexpr int kLeastDepth = 3; // a peak between 40 x 40 points is not seen
  static constexpr int kMostDepth = 10;
  static constexpr double kRelative = 1e-5;
  static constexpr double kAbsolute = 1e-9;
  // Gauss and Legendre's rule of five points on [-1, 1]: Abramowitz and Stegun 1964, table 25.4.
  static constexpr std::array<double, 5> kPoints{-0.906179845938664, -0.538469310105683, 0.0,
                                                 0.538469310105683, 0.906179845938664};
  static constexpr std::array<double, 5> kWeights{0.236926885056189, 0.478628670499366, 0.568888888888889,
                                                  0.478628670499366, 0.236926885056189};

  [[nodiscard]] double byRule(const Rectangle& r) const {
    const double halfX = 0.5 * (r.x1 - r.x0);
    const double halfY = 0.5 * (r.y1 - r.y0);
    double sum = 0.0;
    for (std::size_t i = 0; i < kPoints.size(); ++i) {
      for (std::size_t j = 0; j < kPoints.size(); ++j)
        sum += kWeights[i] * kWeights[j] *
               m_f(r.x0 + halfX * (1.0 + kPoints[i]), r.y0 + halfY * (1.0 + kPoints[j]));
    }
    return sum * halfX * halfY;
  }

  [[nodiscard]] double refine(const Rectangle& r, double whole, int depth) const {
    const double x = 0.5 * (r.x0 + r.x1);
    const double y = 0.5 * (r.y0 + r.y1);
    const std::array<Rectangle, 4> quarters{
        {{r.x0, x, r.y0, y}, {x, r.x1, r.y0, y}, {r.x0, x, y, r.y1}, {x, r.x1, y, r.y1}}};
    std::array<double, 4> parts{};
    std::ranges::transform(quarters, parts.begin(), [this](const Rectangle& q) { return byRule(q); });
    const double sum = parts[0] + parts[1] + parts[2] + parts[3];
    const bool agreed = std::abs(sum - whole) <= std::max(kRelative * std::abs(sum), kAbsolute);
    if (depth >= kMostDepth || (agreed && depth >= kLeastDepth - 1) || !std::isfinite(sum))
      return sum;
    double refined = 0.0;
    for (std::size_t i = 0; i < quarters.size(); ++i)
      refined += refine(quarters[i], parts[i], depth + 1);
    return refined;
  }

  const Integrand& m_f;
};

} // namespace

std::size_t DirectionGrid::cellOf(const Vec3d& direction) const {
  const auto cell = [](double share, int count) { // no number: the first one
    const double at = share * count;
    return at >= 1.0 ? static_cast<std::size_t>(std::min(at, count - 1.0)) : 0;
  };
  const double turn = std::atan2(direction.y, direction.x) / kTwoPi;
  const std::size_t row = cell(0.5 * (direction.z + 1.0), m_rows);
  return row * static_cast<std::size_t>(m_columns) + cell(turn < 0.0 ? turn + 1.0 : turn, m_columns);
}

std::vector<double> DirectionGrid::integrate(const std::function<double(const Vec3d&)>& density) const {
  const Cubature::Integrand overGrid = [&density](double cosTheta, double phi) {
    const double sinTheta = std::sqrt(std::max(1.0 - cosTheta * cosTheta, 0.0));
    return density({sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta});
  };
  const Cubature cubature(overGrid);
  std::vector<double> integrals;
  integrals.reserve(size());
  for (int row = 0; row < m_rows; ++row) {
    for (int column = 0; column < m_columns; ++column) {
      integrals.push_back(
          cubature.integrate({-1.0 + 2.0 * row / m_rows, -1.0 + 2.0 * (row + 1) / m_rows,
                              kTwoPi * column / m_columns, kTwoPi * (column + 1) / m_columns}));
    }
  }
  return integrals;
}

DirectionCounts countDirections(const DirectionGrid& grid, const SampleDirection& sample,
                                const DirectionDensity& density, std::uint32_t samples) {
  DirectionCounts counts;
  counts.cells.resize(grid.size() + 1);
  for (std::uint32_t i = 0; i < samples; ++i) {
    const std::optional<Vec3d> direction = sample(i);
    counts.cells[direction ? grid.cellOf(*direction) : grid.size()].observed += 1.0;
    if (direction && !(density(*direction) > 0.0))
      ++counts.impossible;
  }
  const std::vector<double> shares = grid.integrate(density);
  double left = 1.0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    counts.cells[i].expected = shares[i] * samples;
    left -= shares[i];
  }
  counts.cells.back().expected = std::max(left, 0.0) * samples;
  return counts;
}

} // namespace vkpt
