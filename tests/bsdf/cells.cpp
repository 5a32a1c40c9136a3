#include "bsdf/cells.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace vkpt::test {
namespace {

constexpr int kInnerDepth = 16; // an edge in the integrand is followed this far
constexpr int kOuterDepth = 9;
constexpr int kLeastDepth = 2;
constexpr int kLastColumnDepth = 6; // where charts stretch far: a small part of it may be all that counts

template<class F>
class Simpson {
public:
  Simpson(const F& f, int leastDepth, int depth) : m_f(f), m_leastDepth(leastDepth), m_depth(depth) {}
  [[nodiscard]] Vec2d over(double a, double b, double tolerance) const {
    const Span span{a, b, m_f(a), m_f(0.5 * (a + b)), m_f(b)};
    return refined(span, tolerance, 0);
  }

private:
  struct Span {
    double a, b;
    Vec2d fa, fm, fb;
    [[nodiscard]] Vec2d rule() const { return (fa + 4.0 * fm + fb) * ((b - a) / 6.0); }
  };
  Vec2d refined(const Span& s, double tolerance, int depth) const {
    const double m = 0.5 * (s.a + s.b);
    const Span left{s.a, m, s.fa, m_f(0.5 * (s.a + m)), s.fm};
    const Span right{m, s.b, s.fm, m_f(0.5 * (m + s.b)), s.fb};
    const Vec2d both = left.rule() + right.rule();
    const Vec2d error = (both - s.rule()) / 15.0;
    if (depth >= m_depth ||
        (depth >= m_leastDepth && std::max(std::abs(error.x), std::abs(error.y)) <= tolerance))
      return both + error;
    return refined(left, 0.5 * tolerance, depth + 1) + refined(right, 0.5 * tolerance, depth + 1);
  }
  const F& m_f;
  int m_leastDepth;
  int m_depth;
};

} // namespace

std::size_t Grid::cellOf(const Vec2d& p) const {
  const auto along = [](double x, int n) { return std::clamp(static_cast<int>(x * n), 0, n - 1); };
  return static_cast<std::size_t>(along(p.y, rows)) * static_cast<std::size_t>(columns) +
         static_cast<std::size_t>(along(p.x, columns));
}

std::vector<Vec2d> integrals(const Grid& grid, const std::function<Vec2d(double, double)>& f,
                             double tolerance) {
  std::vector<Vec2d> cells;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const double u0 = static_cast<double>(column) / grid.columns;
      const double u1 = static_cast<double>(column + 1) / grid.columns;
      const int least = column == grid.columns - 1 ? kLastColumnDepth : kLeastDepth;
      const auto across = [&](double v) {
        const auto along = [&](double u) { return f(u, v); };
        return Simpson(along, least, kInnerDepth).over(u0, u1, tolerance * grid.rows);
      };
      cells.push_back(Simpson(across, kLeastDepth, kOuterDepth)
                          .over(static_cast<double>(row) / grid.rows,
                                static_cast<double>(row + 1) / grid.rows, tolerance));
    }
  }
  return cells;
}

} // namespace vkpt::test
