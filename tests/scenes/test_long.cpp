// What takes minutes: deeper furnaces, and every mutation against every check.
#include "scenes/check.h"
#include "scenes/test_shaders.h"

#include <iostream>

namespace vkpt::test {
namespace {

class Long : public RenderTest {};

/// A thousand bounces a path on average: no cap on the depth, no cap on the survival probability.
TEST_F(Long, FurnaceOfAlbedo999) {
  constexpr std::uint64_t kFrames = 46; // of 96 x 96: a standard error of 0.154 %
  for (const RouletteMode mode : {RouletteMode::Throughput, RouletteMode::Albedo}) {
    const Rendered r =
        render(furnace(Vec3f(0.999F)),
               {.estimator = bsdfSampling(mode), .width = 96, .height = 96, .frames = kFrames});
    Trial trial("furnace", sharedContext());
    trial.expectMean(r.film, Vec3d(1.0 / (1.0 - double{0.999F})), 0.005);
    for (const std::string& failure : trial.failures())
      ADD_FAILURE() << failure;
    EXPECT_GT(r.counters.carriedPaths, 0U);
  }
}

/// Prints the table of which check notices what.
class EveryMutation : public RenderTest, public testing::WithParamInterface<MutationInfo> {};

TEST_P(EveryMutation, AgainstEveryCheck) {
  std::string noticed;
  for (const Check& check : allChecks()) {
    Trial trial(check.name, sharedContext(), mutatedKernel(static_cast<std::uint32_t>(GetParam().mutation)));
    trial.run(check.run);
    if (!trial.failures().empty())
      noticed += std::string(" ") + check.name;
  }
  std::cout << GetParam().name << ":" << noticed << '\n';
  EXPECT_FALSE(noticed.empty());
}

INSTANTIATE_TEST_SUITE_P(Of, EveryMutation, testing::ValuesIn(kMutations),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace vkpt::test
