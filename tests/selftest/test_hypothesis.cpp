// The statistics against tables and closed forms.

#include "selftest/hypothesis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace vkpt::test {
namespace {

TEST(Sidak, CorrectsTheLevel) {
  EXPECT_EQ(sidakLevel(0.01, 1), 0.01);
  EXPECT_NEAR(sidakLevel(0.05, 10), 0.005116196891823743, 1e-15); // 1 - 0.95^0.1
  EXPECT_NEAR(sidakLevel(0.75, 2), 0.5, 1e-15);
  EXPECT_NEAR(sidakLevel(1e-12, 4), 2.5e-13, 1e-24) << "without cancellation";
}

TEST(RunningMoments, MeanAndVarianceOfAFewNumbers) {
  RunningMoments moments;
  for (const double x : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0})
    moments.add(x);
  EXPECT_EQ(moments.count(), 8.0);
  EXPECT_DOUBLE_EQ(moments.mean(), 5.0);
  EXPECT_DOUBLE_EQ(moments.variance(), 32.0 / 7.0);
}

TEST(RunningMoments, SurviveALargeOffset) {
  RunningMoments moments;
  for (int i = 0; i < 1000; ++i)
    moments.add(1e9 + i % 2);
  EXPECT_NEAR(moments.variance(), 250.0 / 999.0, 1e-6);
}

TEST(RunningMoments, MeanKnowsItsError) {
  RunningMoments moments;
  for (int i = 0; i < 100; ++i)
    moments.add(i % 2);
  const MeanEstimate estimate = meanOf(moments);
  EXPECT_DOUBLE_EQ(estimate.mean, 0.5);
  EXPECT_DOUBLE_EQ(estimate.variance, 25.0 / 99.0 / 100.0);
  EXPECT_EQ(estimate.degrees, 99.0);
}

TEST(RunningMoments, NoVarianceIsNoCertainty) {
  RunningMoments moments;
  for (int i = 0; i < 100; ++i)
    moments.add(0.5);
  EXPECT_DOUBLE_EQ(meanOf(moments).variance, kLeastSampleVariance / 100.0);
}

double studentP(double t, double degrees) { return studentTest({t, 1.0, degrees}, 0.0).p; }

TEST(StudentTest, Tables) { // two-sided 5 % and 1 % points
  EXPECT_NEAR(studentP(12.706205, 1), 0.05, 5e-6);
  EXPECT_NEAR(studentP(2.228139, 10), 0.05, 1e-5);
  EXPECT_NEAR(studentP(-2.228139, 10), 0.05, 1e-5);
  EXPECT_NEAR(studentP(3.169273, 10), 0.01, 1e-5);
  EXPECT_NEAR(studentP(2.042272, 30), 0.05, 5e-5);
  EXPECT_NEAR(studentP(1.959964, 1e9), 0.05, 1e-7) << "normal in the limit";
}

TEST(StudentTest, ClosedForms) {
  for (const double t : {0.1, 1.0, 3.0, 100.0}) {
    EXPECT_NEAR(studentP(t, 1), 1.0 - 2.0 / std::numbers::pi * std::atan(t), 1e-13) << "Cauchy";
    EXPECT_NEAR(studentP(t, 2), 1.0 - t / std::sqrt(2.0 + t * t), 1e-13);
  }
}

TEST(StudentTest, DifferenceInStandardErrors) {
  const TestStatistic t = studentTest({5.0, 4.0, 20.0}, 8.0);
  EXPECT_EQ(t.value, -1.5);
  EXPECT_EQ(t.degrees, 20.0);
  EXPECT_TRUE(t.why.empty());
}

TEST(StudentTest, WhatIsNotFiniteFails) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const MeanEstimate& e : {MeanEstimate{kNan, 1.0, 9.0}, MeanEstimate{kInfinity, 1.0, 9.0},
                                MeanEstimate{1.0, kNan, 9.0}, MeanEstimate{1.0, 1.0, 0.0}}) {
    const TestStatistic t = studentTest(e, 1.0);
    EXPECT_EQ(t.p, 0.0);
    EXPECT_FALSE(t.why.empty());
  }
}

TEST(ChiSquareTest, Tables) { // 60 throws of a die
  const auto p = [](double deviation) {
    std::vector<CellCount> cells(6, {10.0, 10.0});
    cells[0].observed += deviation;
    cells[1].observed -= deviation;
    return chiSquareTest(cells, 5.0);
  };
  const TestStatistic atFive = p(std::sqrt(11.0705 * 10.0 / 2.0)); // 5 % point for 5 degrees of freedom
  EXPECT_NEAR(atFive.value, 11.0705, 1e-9);
  EXPECT_EQ(atFive.degrees, 5.0);
  EXPECT_NEAR(atFive.p, 0.05, 1e-6);
  EXPECT_NEAR(p(std::sqrt(15.0863 * 10.0 / 2.0)).p, 0.01, 1e-6);
  EXPECT_EQ(p(0.0).p, 1.0);
}

TEST(ChiSquareTest, TwoDegreesOfFreedomAreExponential) {
  const std::vector<CellCount> cells{{20.0, 10.0}, {5.0, 10.0}, {5.0, 10.0}};
  EXPECT_NEAR(chiSquareTest(cells, 5.0).p, std::exp(-15.0 / 2.0), 1e-15);
}

TEST(ChiSquareTest, PoolsTheRareFirst) {
  // 1 + 2 + 3 make a pool of 6, observed 8; then 10 and 20 alone.
  const std::vector<CellCount> cells{{20.0, 20.0}, {4.0, 3.0}, {10.0, 10.0}, {2.0, 2.0}, {2.0, 1.0}};
  const TestStatistic chi2 = chiSquareTest(cells, 5.0);
  EXPECT_EQ(chi2.degrees, 2.0);
  EXPECT_DOUBLE_EQ(chi2.value, 4.0 / 6.0);
}

TEST(ChiSquareTest, WhatIsLeftJoinsTheLastPool) {
  // 4 + 4 make a pool; the third 4 is left.
  const std::vector<CellCount> cells(3, {6.0, 4.0});
  const std::vector<CellCount> four{{6.0, 4.0}, {6.0, 4.0}, {6.0, 4.0}, {6.0, 4.0}, {6.0, 4.0}};
  EXPECT_FALSE(chiSquareTest(cells, 5.0).why.empty()) << "one pool is no test";
  const TestStatistic chi2 = chiSquareTest(four, 5.0);
  EXPECT_EQ(chi2.degrees, 1.0);
  EXPECT_DOUBLE_EQ(chi2.value, 16.0 / 8.0 + 36.0 / 12.0);
}

TEST(ChiSquareTest, SamplesWhereNoneAreExpectedAreNotOverlooked) {
  EXPECT_EQ(chiSquareTest(std::vector<CellCount>{{0.0, 0.0}, {50.0, 50.0}, {50.0, 50.0}}, 5.0).p, 1.0);
  EXPECT_LT(chiSquareTest(std::vector<CellCount>{{50.0, 0.0}, {50.0, 50.0}, {50.0, 50.0}}, 5.0).p, 1e-9);
}

TEST(ChiSquareTest, WhatIsNoNumberFails) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double expected : {kNan, -1.0}) {
    const TestStatistic chi2 =
        chiSquareTest(std::vector<CellCount>{{5.0, expected}, {5.0, 5.0}, {5.0, 5.0}}, 5.0);
    EXPECT_EQ(chi2.p, 0.0);
    EXPECT_FALSE(chi2.why.empty());
  }
}

} // namespace
} // namespace vkpt::test
