// What lavapipe does to shaders in silence, and that the style of our kernels is safe from it.
#include "scenes/render_fixture.h"
#include "scenes/test_shaders.h"
#include "selftest/small_program.h"

#include <algorithm>
#include <array>
#include <iostream>

namespace vkpt::test {
namespace {

constexpr std::size_t kLanes = 64;

/// The driver on which the traps were found; others may be free of them.
bool knownDriver() { return sharedContext().info().driver.find("Mesa 22.3") != std::string::npos; }

class DriverTraps : public RenderTest {};

using LoopState = std::array<std::uint32_t, 4>; // outer, inner, count, unused

std::vector<LoopState> runLoop(const std::vector<LoopState>& before, std::uint32_t budget) {
  std::vector<LoopState> after(before.size());
  runSmallProgram(sharedContext(), {spirv::kLoopLimit, {{0U, budget}}}, std::as_bytes(std::span{before}),
                  std::as_writable_bytes(std::span{after}));
  return after;
}

/// All loops of a subgroup together are cut after 65 535 iterations: 1000 x 100 come out short. With a budget
/// below that, and dispatch after dispatch, as path.comp does it, they come out right.
TEST_F(DriverTraps, LoopsUnderABudgetAreNotCut) {
  constexpr std::uint32_t kIterations = 1000 * 100;
  constexpr std::uint32_t kBudget = 24000;
  constexpr std::uint32_t kNoBudget = 0xFFFFFFFFU;
  const auto naive = runLoop(std::vector<LoopState>(kLanes), kNoBudget);
  const std::uint32_t counted = std::ranges::max(naive, {}, [](const LoopState& s) { return s[2]; })[2];
  std::cout << "without a budget " << counted << " of " << kIterations << " iterations are made\n";
  if (knownDriver()) {
    EXPECT_LT(counted, 65536U) << "the loop limiter is not where the kernels' budget expects it";
  }

  std::vector<LoopState> state(kLanes);
  std::uint32_t dispatches = 0;
  while (std::ranges::any_of(state, [](const LoopState& s) { return s[0] < 1000; }) && dispatches < 100) {
    state = runLoop(state, kBudget);
    ++dispatches;
  }
  EXPECT_EQ(dispatches, (kIterations + kBudget - 1) / kBudget);
  for (const LoopState& s : state)
    EXPECT_EQ(s[2], kIterations);
}

struct Kept {
  std::uint32_t afterLoop;
  std::uint32_t insideLoop;
};

/// Lane n leaves a loop in round n with the value it has just loaded. Read after the loop it is wrong in most
/// lanes: they get what the last lane loaded. Stored before the break, as our kernels do, it is right.
TEST_F(DriverTraps, StoresInsideTheLoopAreRight) {
  std::vector<std::uint32_t> data(kLanes * kLanes);
  for (std::uint32_t i = 0; i < data.size(); ++i)
    data[i] = 1000 + i;
  std::vector<Kept> kept(kLanes);
  runSmallProgram(sharedContext(), {spirv::kDivergence}, std::as_bytes(std::span{data}),
                  std::as_writable_bytes(std::span{kept}));
  std::size_t wrong = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const std::uint32_t right = data[lane * kLanes + lane];
    EXPECT_EQ(kept[lane].insideLoop, right) << "lane " << lane;
    wrong += kept[lane].afterLoop != right ? 1U : 0U;
  }
  std::cout << "read after the loop, the value is wrong in " << wrong << " of " << kLanes << " lanes\n";
  if (knownDriver()) {
    EXPECT_GT(wrong, 0U) << "the trap is not shown";
  }
}

} // namespace
} // namespace vkpt::test
