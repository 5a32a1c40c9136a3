// Each known mistake of the second list (shaders/shared/mutations.h) is noticed by a check of the BSDFs.
#include "bsdf/probe_shaders.h"
#include "bsdf/sampling_checks.h"

#include <iostream>

namespace vkpt::test {
namespace {

/// Few, each able to notice something: the checks are dear.
constexpr const char* kCases[] = {"ggxMetal0.3 at 45 degrees", "beckmannMetal0.3 at 45 degrees",
                                  "ggxGlass0.3 at 45 degrees, from behind", "microfacet0.3 at 45 degrees"};

Failures failuresOf(std::uint32_t mutation) {
  BsdfBench bench(mutation);
  for (const BsdfCase& c : bsdfCases()) {
    if (std::ranges::find(kCases, c.name) == std::end(kCases))
      continue;
    Failures found = checkDensity(bench, c, bsdfCases().size());
    for (const auto& check : {checkWeights, checkEvaluation}) {
      const Failures more = check(bench, c);
      found.insert(found.end(), more.begin(), more.end());
    }
    if (!found.empty())
      return found;
  }
  return {};
}

class SamplingMutations : public RenderTest, public testing::WithParamInterface<SamplingMutation> {};

TEST_P(SamplingMutations, IsNoticed) {
  const Failures failures = failuresOf(GetParam().id);
  for (const std::string& failure : failures)
    std::cout << GetParam().name << " is noticed by " << failure << '\n';
  EXPECT_FALSE(failures.empty()) << GetParam().name << " (" << GetParam().what << ")";
}

INSTANTIATE_TEST_SUITE_P(Of, SamplingMutations, testing::ValuesIn(kSamplingMutations),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace vkpt::test
