#pragma once
// Hypothesis tests: how likely is what was measured, if the claim is true?

#include <cstddef>
#include <span>
#include <string>

namespace vkpt {

/// Šidák's correction: the level of each of `tests` independent tests, so that by chance alone one or more of
/// them fail with the probability `level`. 1 - (1 - level)^(1 / tests), exact for small levels too.
double sidakLevel(double level, std::size_t tests);

/// Mean and sum of squared deviations of numbers that come one by one: Welford 1962, "Note on a Method for
/// Calculating Corrected Sums of Squares and Products".
class RunningMoments {
public:
  void add(double x) {
    m_count += 1.0;
    const double delta = x - m_mean;
    m_mean += delta / m_count;
    m_squares += delta * (x - m_mean);
  }
  [[nodiscard]] double count() const { return m_count; }
  [[nodiscard]] double mean() const { return m_mean; }
  /// Of one number, unbiased; for two or more.
  [[nodiscard]] double variance() const { return m_squares / (m_count - 1.0); }

private:
  double m_count = 0.0;
  double m_mean = 0.0;
  double m_squares = 0.0;
};

struct MeanEstimate {
  double mean = 0.0;
  double variance = 0.0; ///< of the mean: the squared standard error
  double degrees = 1.0;  ///< of freedom of that variance
};

/// As Nori has it, a sample's variance counts as this at least: references have few digits, weights are
/// floats.
inline constexpr double kLeastSampleVariance = 1e-5;

/// Of independent samples.
MeanEstimate meanOf(const RunningMoments& samples);

struct TestStatistic {
  const char* name = ""; ///< "t" or "chi2"
  double value = 0.0;
  double degrees = 0.0; ///< of freedom
  double p = 0.0;  ///< probability of such a value or a more extreme one; 0 where something is not finite
  std::string why; ///< what alone decides that the test fails; empty: p decides
};

/// Student's t-test, two-sided, that the mean is `reference`.
TestStatistic studentTest(const MeanEstimate& estimate, double reference);

struct CellCount {
  double observed = 0.0;
  double expected = 0.0;
};

/// Pearson's test that the observed numbers follow the expected ones. Cells are pooled, those of the fewest
/// expected samples first, until each has `leastExpected`; with fewer than two pools the test fails.
TestStatistic chiSquareTest(std::span<const CellCount> cells, double leastExpected);

} // namespace vkpt
