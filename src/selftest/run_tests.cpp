#include "selftest/run_tests.h"

#include "selftest/bsdf_directions.h"
#include "selftest/bsdf_means.h"

#include <fmt/format.h>

#include <algorithm>

namespace vkpt {
namespace {

/// For each block of a file numbers of its own.
class Seeds {
public:
  explicit Seeds(std::uint32_t seed) : m_next(seed) {}
  std::uint32_t next() { return m_next += 0x9E3779B9U; } // 2^32 over the golden ratio: far from each other

private:
  std::uint32_t m_next;
};

} // namespace

std::string outcomeText(const TestOutcome& outcome) {
  const TestStatistic& s = outcome.statistic;
  std::string verdict = s.why;
  if (verdict.empty()) {
    verdict = fmt::format("{} {:.4g} with {:.6g} degrees of freedom, p {:.3g}, passes above {:.3g}", s.name,
                          s.value, s.degrees, s.p, outcome.level);
  }
  return fmt::format("{} {}: {}: {}; {}", outcome.passed() ? "pass" : "FAIL", outcome.where.text(),
                     outcome.what, outcome.figures, verdict);
}

SelftestCounts runTests(const NoriTests& tests, std::uint32_t seed, const TestScenes& testScenes,
                        const TellOutcome& tell) {
  std::ranges::for_each(tests.chi2Tests, checkDensities);
  SelftestCounts counts;
  const TellOutcome count = [&](const TestOutcome& outcome) {
    ++(outcome.passed() ? counts.passed : counts.failed);
    tell(outcome);
  };
  Seeds seeds(seed);
  for (const NoriChi2Test& test : tests.chi2Tests)
    testBsdfDirections(test, seeds.next(), count);
  for (const NoriTTest& test : tests.tTests) {
    if (test.scenes.empty())
      testBsdfMeans(test, seeds.next(), count);
    else
      testScenes(test, seeds.next(), count);
  }
  return counts;
}

} // namespace vkpt
