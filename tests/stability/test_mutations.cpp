// Each case fails against a naive version of what it looks at (shaders/shared/mutations.h).
#include "scenes/render_fixture.h"
#include "scenes/test_shaders.h"
#include "selftest/case.h"
#include "stability/killers.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace vkpt::test {
namespace {

class StabilityMutations : public RenderTest, public testing::WithParamInterface<Killer> {};

TEST_P(StabilityMutations, IsNoticed) {
  const Case* which = findCase(GetParam().which);
  ASSERT_NE(which, nullptr) << GetParam().which;
  const CaseResult result = runCase(*which, sharedContext(), mutatedKernel(GetParam().mutation));
  ASSERT_FALSE(result.passed()) << GetParam().which << " passes with mistake " << GetParam().mutation;
  std::cout << "noticed: " << result.failures.front() << '\n';
}

std::string killerName(const testing::TestParamInfo<Killer>& info) {
  std::string name = fmt::format("{}_by_{}", info.param.which, info.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Of, StabilityMutations, testing::ValuesIn(VKPT_KILLERS), killerName);

} // namespace
} // namespace vkpt::test
