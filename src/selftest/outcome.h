#pragma once
// What a test found.

#include "core/error.h"
#include "selftest/hypothesis.h"

#include <functional>
#include <string>

namespace vkpt {

struct TestOutcome {
  SourceLocation where; ///< the test's or its BSDF's
  std::string what;     ///< "diffuse at 30 degrees"
  std::string figures;  ///< what was measured and what is right: "mean 0.5001, reference 0.5"
  TestStatistic statistic;
  double level = 0.0; ///< the test passes where `statistic.p` is above it
  [[nodiscard]] bool passed() const { return statistic.why.empty() && statistic.p > level; }
};

/// Called with each outcome as soon as it is known.
using TellOutcome = std::function<void(const TestOutcome&)>;

/// One line: "pass file.xml:3:5: diffuse at 30 degrees: mean 0.5001, reference 0.5, t 0.3, 9999 degrees of
/// freedom, p 0.76, passes above 0.01".
std::string outcomeText(const TestOutcome& outcome);

} // namespace vkpt
