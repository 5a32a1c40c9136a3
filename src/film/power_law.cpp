#include "film/power_law.h"

#include <cmath>

namespace vkpt {
namespace {

constexpr std::size_t kLeastLooks = 3;
constexpr double kIndependent = -0.5;
constexpr double kSlowestFall = -0.05; // a millionfold work for half of it: not worth a figure

bool isUsable(const ErrorAtWork& p) {
  return std::isfinite(p.work) && p.work > 0.0 && std::isfinite(p.error) && p.error > 0.0;
}

} // namespace

double PowerLaw::errorAfter(double work) const { return factor * std::pow(work, exponent); }

std::optional<double> PowerLaw::workFor(double error) const {
  if (!(exponent < 0.0 && error > 0.0))
    return std::nullopt;
  return std::pow(error / factor, 1.0 / exponent);
}

std::optional<PowerLaw> fitPowerLaw(std::span<const ErrorAtWork> points) {
  double n = 0.0, x = 0.0, y = 0.0;
  for (const ErrorAtWork& p : points) {
    if (!isUsable(p))
      continue;
    n += 1.0;
    x += std::log(p.work);
    y += std::log(p.error);
  }
  if (n < 2.0)
    return std::nullopt;
  x /= n;
  y /= n;
  double xx = 0.0, xy = 0.0;
  for (const ErrorAtWork& p : points) {
    if (!isUsable(p))
      continue;
    const double dx = std::log(p.work) - x;
    xx += dx * dx;
    xy += dx * (std::log(p.error) - y);
  }
  if (!(xx > 0.0))
    return std::nullopt;
  const double exponent = xy / xx;
  return PowerLaw{exponent, std::exp(y - exponent * x)};
}

std::optional<CostOfError> costOfError(double share, std::span<const ErrorAtWork> looks, double work) {
  if (looks.empty() || !isUsable(looks.back()))
    return std::nullopt;
  CostOfError cost{0.0, kIndependent, false};
  if (looks.size() >= kLeastLooks) {
    const std::optional<PowerLaw> law = fitPowerLaw(looks);
    if (!law || law->exponent > kSlowestFall)
      return std::nullopt;
    cost.exponent = law->exponent;
    cost.measured = true;
  }
  cost.more = work * (std::pow(share, 1.0 / cost.exponent) - 1.0);
  return cost;
}

} // namespace vkpt
