// What takes minutes.
#include "scenes/render_fixture.h"
#include "selftest/leaks.h"

namespace vkpt::test {
namespace {

class StabilityLong : public RenderTest {};

TEST_F(StabilityLong, NoneOf1e8RaysLeavesAClosedMesh) {
  selftest::Trial trial("leaks", sharedContext());
  selftest::lightOutsideStaysOutside(trial, 1e8);
  for (const std::string& failure : trial.failures())
    ADD_FAILURE() << failure;
  EXPECT_EQ(trial.figures().size(), 2U);
}

} // namespace
} // namespace vkpt::test
