// Each naive way to trace rays is noticed by a case.
#include "scenes/render_fixture.h"
#include "scenes/test_shaders.h"
#include "selftest/case.h"

namespace vkpt::test {
namespace {

struct Noticed {
  GeometryMutation mutation;
  const char* name; ///< of the mutation
  const char* by;   ///< a case
};

class NaiveGeometry : public RenderTest, public testing::WithParamInterface<Noticed> {};

TEST_P(NaiveGeometry, IsNoticed) {
  const Case* which = selftest::findCase(GetParam().by);
  ASSERT_NE(which, nullptr);
  const CaseResult result =
      runCase(*which, sharedContext(), mutatedKernel(static_cast<std::uint32_t>(GetParam().mutation)));
  EXPECT_FALSE(result.passed()) << GetParam().by << " holds with a mistake in the kernel";
  if (!result.passed())
    std::cout << result.failures.front() << '\n';
}

INSTANTIATE_TEST_SUITE_P(
    By, NaiveGeometry,
    testing::Values(
        Noticed{GeometryMutation::LeakyTriangle, "LeakyTriangle", "w2-rays-at-vertices-and-edges"},
        Noticed{GeometryMutation::AbsoluteOffset, "AbsoluteOffset", "o1-same-at-every-scale-and-place"},
        Noticed{GeometryMutation::NaiveGeometry, "NaiveGeometry", "o4-camera-in-a-corner"},
        Noticed{GeometryMutation::FrisvadFrame, "FrisvadFrame", "o4-camera-in-a-corner"},
        Noticed{GeometryMutation::TiesAtRandom, "TiesAtRandom", "w9-faces-in-one-plane"}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace vkpt::test
