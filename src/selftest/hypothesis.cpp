#include "selftest/hypothesis.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace vkpt {
namespace {

/// Cells merged, those of the fewest expected samples first, until each has enough.
std::vector<CellCount> pooled(std::span<const CellCount> cells, double leastExpected) {
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return cells[i].expected; });
  std::vector<CellCount> pools;
  bool open = false;
  for (const std::size_t i : order) {
    if (!open)
      pools.emplace_back();
    pools.back().observed += cells[i].observed;
    pools.back().expected += cells[i].expected;
    open = pools.back().expected < leastExpected;
  }
  if (open && pools.size() > 1) {
    const CellCount rest = pools.back();
    pools.pop_back();
    pools.back().observed += rest.observed;
    pools.back().expected += rest.expected;
  }
  return pools;
}

} // namespace

double sidakLevel(double level, std::size_t tests) {
  return -std::expm1(std::log1p(-level) / static_cast<double>(tests));
}

MeanEstimate meanOf(const RunningMoments& samples) {
  return {samples.mean(), std::max(samples.variance(), kLeastSampleVariance) / samples.count(),
          samples.count() - 1.0};
}

TestStatistic studentTest(const MeanEstimate& estimate, double reference) {
  TestStatistic t;
  t.name = "t";
  t.value = (estimate.mean - reference) / std::sqrt(estimate.variance);
  t.degrees = estimate.degrees;
  if (!std::isfinite(t.value) || !(t.degrees > 0.0)) {
    t.why = "not finite";
    return t;
  }
  const boost::math::students_t distribution(t.degrees);
  t.p = 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(t.value)));
  return t;
}

TestStatistic chiSquareTest(std::span<const CellCount> cells, double leastExpected) {
  TestStatistic chi2;
  chi2.name = "chi2";
  if (!std::ranges::all_of(cells, [](const CellCount& cell) { return cell.expected >= 0.0; })) {
    chi2.why = "an expected number is negative or none at all";
    return chi2;
  }
  const std::vector<CellCount> pools = pooled(cells, leastExpected);
  if (pools.size() < 2) {
    chi2.why = "fewer than two cells are left; give more samples";
    return chi2;
  }
  for (const CellCount& pool : pools) {
    const double difference = pool.observed - pool.expected;
    chi2.value += difference * difference / pool.expected;
  }
  chi2.degrees = static_cast<double>(pools.size() - 1);
  if (!std::isfinite(chi2.value)) {
    chi2.why = "not finite";
    return chi2;
  }
  chi2.p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(chi2.degrees), chi2.value));
  return chi2;
}

} // namespace vkpt
