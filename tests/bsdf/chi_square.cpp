#include "bsdf/chi_square.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace vkpt::test {
namespace {

constexpr double kLeastExpected = 5.0;

} // namespace

std::string ChiSquare::figures() const {
  return fmt::format("chi^2 {:.1f} of {} degrees of freedom, p = {:.2g}", statistic, freedom, probability);
}

ChiSquare chiSquare(std::span<const double> observed, std::span<const double> expected) {
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return expected[i]; });
  ChiSquare result;
  int pools = 0;
  double o = 0.0;
  double e = 0.0;
  const auto close = [&] {
    result.statistic += e > 0.0 ? (o - e) * (o - e) / e : o * 1e30;
    ++pools;
    o = e = 0.0;
  };
  double left = std::accumulate(expected.begin(), expected.end(), 0.0);
  for (const std::size_t i : order) {
    o += observed[i];
    e += expected[i];
    left -= expected[i];
    if (e >= kLeastExpected && left >= kLeastExpected)
      close();
  }
  if (e > 0.0 || o > 0.0)
    close();
  result.freedom = pools - 1;
  if (result.freedom > 0) {
    const boost::math::chi_squared distribution(result.freedom);
    result.probability = boost::math::cdf(boost::math::complement(distribution, result.statistic));
  }
  return result;
}

} // namespace vkpt::test
