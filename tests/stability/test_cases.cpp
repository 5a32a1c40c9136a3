// Every case of `vkpt selftest`, under the validation layer: what a user runs and what is tested are the
// same.
#include "scenes/render_fixture.h"
#include "selftest/case.h"

#include <algorithm>

namespace vkpt::test {
namespace {

class Stability : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(Stability, Holds) {
  const CaseResult result = runCase(GetParam(), sharedContext());
  EXPECT_GT(result.figures.size() + result.conditions, 1U) << "a case that looks at nothing";
  for (const std::string& failure : result.failures)
    ADD_FAILURE() << failure;
  for (std::size_t i = 0; i < result.pictures.size() && !result.passed(); ++i)
    std::cout << "picture: " << savePicture(result.pictures[i], std::to_string(i)) << '\n';
}

std::string testName(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Of, Stability, testing::ValuesIn(allCases()), testName);

TEST(StabilityCases, HaveNamesOfTheirOwn) {
  std::vector<std::string> names;
  for (const Case& c : allCases())
    names.emplace_back(c.name);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

} // namespace
} // namespace vkpt::test
