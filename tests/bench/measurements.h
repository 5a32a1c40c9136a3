#pragma once
// What was measured: rates by name, and the ratios that the goals speak of.

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace vkpt::bench {

double median(std::vector<double> values);

/// Rates of one benchmark, one entry a round, in 1e6 items a second.
struct Rates {
  std::vector<double> wall; ///< by the clock
  std::vector<double> core; ///< by the process's time on the processor: what others run does not count
};

/// Collects what Google Benchmark runs.
class Collector : public benchmark::BenchmarkReporter {
public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;
  [[nodiscard]] const Rates& of(const std::string& name) const { return m_rates.at(name); }

private:
  std::map<std::string, Rates> m_rates;
};

/// One row of the table: ours against the yardstick's, taken in turns.
struct Comparison {
  std::string scene;
  std::string what; ///< "paths", or the kind of rays
  double ours;      ///< medians, 1e6 a second
  double yardstick;
  double ratio; ///< median of the rounds' ratios
  double coreRatio;
  double oursCore; ///< as `ours`, by the time on the processor
  double yardstickCore;
  double lowest;       ///< of the rounds' ratios
  double disagreement; ///< share of rays with another result; 0 for paths
};
Comparison compare(const Rates& ours, const Rates& yardstick);

} // namespace vkpt::bench
