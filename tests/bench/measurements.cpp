#include "measurements.h"

#include <algorithm>

namespace vkpt::bench {
namespace {

std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> r;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    r.push_back(a[i] / b[i]);
  return r;
}

} // namespace

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

void Collector::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    const double items = run.counters.at("items") * 1e-6;
    Rates& rates = m_rates[run.run_name.function_name];
    rates.wall.push_back(items / run.real_accumulated_time);
    rates.core.push_back(items / run.cpu_accumulated_time);
  }
}

Comparison compare(const Rates& ours, const Rates& yardstick) {
  const std::vector<double> wall = ratios(ours.wall, yardstick.wall);
  return {.scene = {},
          .what = {},
          .ours = median(ours.wall),
          .yardstick = median(yardstick.wall),
          .ratio = median(wall),
          .coreRatio = median(ratios(ours.core, yardstick.core)),
          .oursCore = median(ours.core),
          .yardstickCore = median(yardstick.core),
          .lowest = *std::ranges::min_element(wall),
          .disagreement = 0.0};
}

} // namespace vkpt::bench
