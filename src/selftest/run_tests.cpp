#include "selftest/run_tests.h"

#include "selftest/bsdf_directions.h"
#include "selftest/bsdf_means.h"
#include "selftest/scene_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

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

SelftestCounts runTests(const NoriTests& tests, const SelftestSettings& settings, const TellOutcome& tell) {
  std::ranges::for_each(tests.chi2Tests, checkDensities);
  SelftestCounts counts;
  const TellOutcome count = [&](const TestOutcome& outcome) {
    ++(outcome.passed() ? counts.passed : counts.failed);
    tell(outcome);
  };
  Seeds seeds(settings.seed);
  for (const NoriChi2Test& test : tests.chi2Tests)
    testBsdfDirections(test, seeds.next(), count);
  std::optional<gpu::Context> context;
  for (const NoriTTest& test : tests.tTests) {
    const std::uint32_t seed = seeds.next();
    if (test.scenes.empty()) {
      testBsdfMeans(test, seed, count);
      continue;
    }
    if (!context)
      context.emplace(settings.device);
    testSceneMeans(test, *context, settings.estimator, seed, count);
  }
  counts.validationMessages = context ? context->validationMessages() : 0;
  return counts;
}

} // namespace vkpt
