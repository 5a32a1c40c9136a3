// The fall of an error, on models whose answer is known.

#include "film/power_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace vkpt {
namespace {

std::vector<ErrorAtWork> model(double factor, double exponent, std::initializer_list<double> works) {
  std::vector<ErrorAtWork> points;
  for (const double work : works)
    points.push_back({work, factor * std::pow(work, exponent)});
  return points;
}

TEST(PowerLaw, FindsTheLawThatMadeThePoints) {
  for (const double exponent : {-1.0, -0.5, -0.73, 0.0}) {
    const auto law = fitPowerLaw(model(0.3, exponent, {1, 2, 4, 17, 300}));
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponent, exponent, 1e-12);
    EXPECT_NEAR(law->factor, 0.3, 1e-12);
    EXPECT_NEAR(law->errorAfter(9.0), 0.3 * std::pow(9.0, exponent), 1e-12);
  }
}

TEST(PowerLaw, WorkForAnErrorIsTheInverse) {
  const auto law = fitPowerLaw(model(0.8, -0.5, {1, 16}));
  EXPECT_NEAR(*law->workFor(0.1), 64.0, 1e-9);
  EXPECT_FALSE(fitPowerLaw(model(0.8, 0.0, {1, 16}))->workFor(0.1)); // it does not fall
}

TEST(PowerLaw, NeedsTwoDifferentAmountsOfWork) {
  EXPECT_FALSE(fitPowerLaw({}));
  EXPECT_FALSE(fitPowerLaw(model(1.0, -0.5, {4})));
  EXPECT_FALSE(fitPowerLaw(model(1.0, -0.5, {4, 4, 4})));
}

TEST(PowerLaw, LeavesOutWhatHasNoLogarithm) {
  auto points = model(2.0, -0.5, {1, 4, 16});
  points.push_back({64.0, 0.0});
  points.push_back({128.0, INFINITY});
  points.push_back({0.0, 1.0});
  EXPECT_NEAR(fitPowerLaw(points)->exponent, -0.5, 1e-12);
}

TEST(CostOfError, OfHalfIsThreeTimesTheWorkForIndependentSamples) {
  const auto cost = costOfError(0.5, model(0.4, -0.5, {16, 32, 64}), 10.0);
  ASSERT_TRUE(cost);
  EXPECT_TRUE(cost->measured);
  EXPECT_NEAR(cost->more, 30.0, 1e-9);
}

TEST(CostOfError, FollowsTheMeasuredSlope) {
  // twice the work for half the error: as much again
  EXPECT_NEAR(costOfError(0.5, model(0.4, -1.0, {16, 32, 64, 128}), 10.0)->more, 10.0, 1e-9);
  EXPECT_NEAR(costOfError(0.5, model(0.4, -0.25, {16, 32, 64}), 10.0)->more, 150.0, 1e-9);
}

TEST(CostOfError, TakesTheLawOfIndependentSamplesForWantOfLooks) {
  const auto cost = costOfError(0.5, model(0.4, -1.0, {16, 32}), 10.0);
  ASSERT_TRUE(cost);
  EXPECT_FALSE(cost->measured);
  EXPECT_NEAR(cost->more, 30.0, 1e-9);
}

TEST(CostOfError, GrowsWithTheSquareOfIndependentSamplesPrecision) {
  EXPECT_NEAR(costOfError(0.1, model(0.4, -0.5, {16, 32, 64}), 10.0)->more, 990.0, 1e-6);
  EXPECT_NEAR(costOfError(0.9, model(0.4, -1.0, {16, 32, 64}), 9.0)->more, 1.0, 1e-9);
}

TEST(CostOfError, IsNotKnownWithoutAnErrorOrWhereItDoesNotFall) {
  EXPECT_FALSE(costOfError(0.5, {}, 10.0));
  const std::vector<ErrorAtWork> unknown{{1.0, INFINITY}};
  EXPECT_FALSE(costOfError(0.5, unknown, 10.0));
  EXPECT_FALSE(costOfError(0.5, model(0.4, 0.1, {16, 32, 64}), 10.0));
}

} // namespace
} // namespace vkpt
