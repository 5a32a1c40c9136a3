// Every named check holds on the shipped kernels, and on the test build of them with no mutation switched on.
#include "scenes/check.h"

namespace vkpt::test {
namespace {

class NamedCheck : public RenderTest, public testing::WithParamInterface<Check> {
protected:
  static void holdsOn(const Kernel& kernel) {
    Trial trial(GetParam().name, sharedContext(), kernel);
    GetParam().run(trial);
    for (const std::string& failure : trial.failures())
      ADD_FAILURE() << failure;
    for (std::size_t i = 0; i < trial.pictures().size() && !trial.failures().empty(); ++i) {
      std::cout << "picture: " << savePicture(trial.pictures()[i], GetParam().name + std::to_string(i))
                << '\n';
    }
  }
};

TEST_P(NamedCheck, Holds) { holdsOn({}); }

INSTANTIATE_TEST_SUITE_P(Scenes, NamedCheck, testing::ValuesIn(ownChecks()),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace vkpt::test
