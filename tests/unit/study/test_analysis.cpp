// The arithmetic of a study, on runs whose law is known.

#include "study/study_analysis.h"
#include "study/study_report.h"
#include "study/study_tables.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vkpt {
namespace {

/// relMSE = factor / frames at 1, 2, 4, ... 2^(looks - 1) frames of `perFrame` seconds.
StudyRun lawfulRun(double factor, double perFrame, int looks, double exponent = -1.0) {
  StudyRun run;
  for (int i = 0; i < looks; ++i) {
    const auto frames = std::uint64_t{1} << static_cast<unsigned>(i);
    const auto n = static_cast<double>(frames);
    const double error = factor * std::pow(n, exponent);
    run.points.push_back({frames, n * perFrame, {error, error}, frames > 1 ? error : 0.0});
  }
  run.mean = Vec3d(1.0);
  return run;
}

StudyResult resultOf(const std::vector<std::pair<std::string, std::vector<StudyRun>>>& settings) {
  StudyResult result;
  for (const auto& [name, runs] : settings) {
    SettingResult setting;
    setting.setting.name = name;
    setting.runs = runs;
    result.settings.push_back(setting);
  }
  result.referenceMean = Vec3d(1.0);
  result.equalSeconds = 4.0;
  result.equalFrames = 8;
  return result;
}

TEST(Spread, IsOfSortedValues) {
  EXPECT_FALSE(spreadOf({}));
  const Spread odd = *spreadOf({5.0, 1.0, 2.0});
  EXPECT_EQ(odd.median, 2.0);
  EXPECT_EQ(odd.least, 1.0);
  EXPECT_EQ(odd.most, 5.0);
  EXPECT_EQ(spreadOf({1.0, 2.0, 4.0, 100.0})->median, 3.0);
}

TEST(Estimate, HasTheStandardErrorOfAMean) {
  const Estimate e = *estimateOf({1.0, 2.0, 6.0});
  EXPECT_DOUBLE_EQ(e.value, 3.0);
  EXPECT_DOUBLE_EQ(*e.standardError, std::sqrt((4.0 + 1.0 + 9.0) / 6.0));
  EXPECT_FALSE(estimateOf({1.0})->standardError);
}

TEST(RelMse, IsInterpolatedBetweenLogarithms) {
  const StudyRun run = lawfulRun(0.8, 0.5, 6); // 0.8 * 0.5 / t
  for (const double t : {0.5, 0.7, 3.0, 16.0})
    EXPECT_NEAR(*relMseAt(run, t), 0.4 / t, 1e-12) << t;
  for (const double t : {0.1, 40.0})
    EXPECT_FALSE(relMseAt(run, t)) << t;
}

TEST(TimeTo, IsReadOffOrExtrapolated) {
  const StudyRun run = lawfulRun(0.8, 0.5, 6); // down to relMSE 0.025 after 16 s
  const auto within = timeTo(run, std::sqrt(0.05));
  ASSERT_TRUE(within);
  EXPECT_FALSE(within->extrapolated);
  EXPECT_NEAR(within->seconds, 8.0, 1e-9);
  const auto beyond = timeTo(run, 0.05);
  ASSERT_TRUE(beyond);
  EXPECT_TRUE(beyond->extrapolated);
  EXPECT_NEAR(beyond->seconds, 0.4 / 0.0025, 1e-9);
}

TEST(TimeTo, IsFollowedNoFartherThanALineIsTrusted) {
  const StudyRun run = lawfulRun(0.8, 0.5, 6); // relMSE 0.4 / t up to 16 s
  const auto near = timeTo(run, std::sqrt(0.4 / 1599.0));
  ASSERT_TRUE(near);
  EXPECT_FALSE(near->beyond);
  EXPECT_NEAR(near->seconds, 1599.0, 1e-6);
  const auto far = timeTo(run, 1e-4);
  ASSERT_TRUE(far);
  EXPECT_TRUE(far->beyond && far->extrapolated);
  EXPECT_NEAR(far->seconds, 1600.0, 1e-9);
}

TEST(TimeTo, IsNeverWhereTheErrorDoesNotFall) {
  EXPECT_FALSE(timeTo(lawfulRun(0.8, 0.5, 6, 0.0), 0.05)); // a bias alone
}

TEST(Summary, FindsSlopesEfficiencyAndEqualFrames) {
  // the second one is four times as noisy and twice as fast
  const auto s = summarise(resultOf({{"a", {lawfulRun(0.8, 0.5, 6), lawfulRun(0.8, 0.5, 6)}},
                                     {"b", {lawfulRun(3.2, 0.25, 7), lawfulRun(3.2, 0.25, 7)}}}));
  ASSERT_EQ(s.size(), 2U);
  for (const SettingSummary& one : s) {
    EXPECT_NEAR(one.slopeOverTime->value, -1.0, 1e-9);
    EXPECT_NEAR(one.slopeOverFrames->value, -1.0, 1e-9);
    EXPECT_NEAR(*one.slopeOverTime->standardError, 0.0, 1e-9);
    EXPECT_FALSE(one.isBiased());
  }
  EXPECT_NEAR(s[0].errorAtEqualTime->median, std::sqrt(0.1), 1e-9);
  EXPECT_NEAR(s[1].errorAtEqualTime->median, std::sqrt(0.2), 1e-9);
  EXPECT_NEAR(s[0].errorAtEqualFrames->median, std::sqrt(0.1), 1e-9);
  EXPECT_NEAR(s[1].errorAtEqualFrames->median, std::sqrt(0.4), 1e-9);
  EXPECT_NEAR(*s[0].efficiency, 1.0, 1e-9);
  EXPECT_NEAR(*s[1].efficiency, 0.5, 1e-9);
  EXPECT_NEAR(s[1].times[0]->seconds, 0.8 / 0.0025, 1e-6);
}

TEST(Summary, FitsWhatHasSettled) {
  StudyRun run = lawfulRun(0.8, 0.5, 8);
  for (StudyPoint& p : run.points) {
    if (p.frames < 8)
      p.seconds *= 3.0; // small dispatches
  }
  const auto s = summarise(resultOf({{"a", {run}}}));
  EXPECT_NEAR(s[0].slopeOverTime->value, -1.0, 1e-9);
  EXPECT_EQ(settledPart(s[0].curve).size(), 5U);
  run.points.resize(5); // too few of them beyond 8 frames
  EXPECT_LT(summarise(resultOf({{"a", {run}}}))[0].slopeOverTime->value, -1.01);
}

TEST(Summary, TakesMediansOverTheSeeds) {
  const auto s =
      summarise(resultOf({{"a", {lawfulRun(0.8, 0.5, 6), lawfulRun(8.0, 0.5, 6), lawfulRun(0.4, 0.5, 6)}}}));
  EXPECT_NEAR(s[0].errorAtEqualTime->median, std::sqrt(0.1), 1e-9);
  EXPECT_NEAR(s[0].errorAtEqualTime->most, 1.0, 1e-9);
  ASSERT_EQ(s[0].curve.size(), 6U);
  EXPECT_NEAR(s[0].curve[3].error.median, std::sqrt(0.1), 1e-9);
  EXPECT_EQ(s[0].curve[3].frames, 8.0);
}

TEST(Summary, AnErrorBelowTheReferencesNoiseIsLeftOut) {
  StudyRun run = lawfulRun(0.8, 0.5, 6);
  run.points[5].error.relMse = -0.001; // by chance, after the subtraction
  const auto s = summarise(resultOf({{"a", {run}}}));
  EXPECT_NEAR(s[0].slopeOverTime->value, -1.0, 1e-9);
  EXPECT_EQ(s[0].curve.size(), 5U);
}

TEST(Summary, TellsABiasFromChance) {
  StudyRun run = lawfulRun(0.8, 0.5, 6);
  run.mean = Vec3d(0.9);
  run.standardError = Vec3d(0.01);
  StudyResult result = resultOf({{"a", {run, run, run, run}}});
  auto s = summarise(result);
  EXPECT_NEAR(s[0].energy.value, -0.1, 1e-12);
  EXPECT_NEAR(*s[0].energy.standardError, 0.005, 1e-12);
  EXPECT_TRUE(s[0].isBiased());
  EXPECT_NE(remarks(result, s).front().find("-10.00 %"), std::string::npos);
  result.referenceMeanError = Vec3d(0.12); // a reference that cannot tell
  EXPECT_FALSE(summarise(result)[0].isBiased());
}

/// 0.8 / frames of variance, and a bias of relMSE 0.01 that stays.
StudyRun biasedRun() {
  StudyRun run = lawfulRun(0.8, 0.5, 6);
  for (StudyPoint& p : run.points)
    p.error.relMse += 0.01;
  run.mean = Vec3d(0.9);
  run.standardError = Vec3d(0.01);
  return run;
}

TEST(Summary, PartsABiasFromTheErrorThatTimeRemoves) {
  StudyResult result = resultOf({{"a", {lawfulRun(0.8, 0.5, 6)}}, {"b", {biasedRun(), biasedRun()}}});
  result.settings[1].setting.bias = {"--max-bounces 2"};
  const auto s = summarise(result);
  EXPECT_NEAR(s[0].lastingRelMse->value, 0.0, 1e-12);
  EXPECT_NEAR(*s[0].measuredOverPredicted, 1.0, 1e-12);
  EXPECT_NEAR(s[1].lastingRelMse->value, 0.01, 1e-12);
  EXPECT_NEAR(*s[1].measuredOverPredicted, std::sqrt((0.025 + 0.01) / 0.025), 1e-12);
  EXPECT_TRUE(s[0].times[0]->extrapolated);
  EXPECT_FALSE(s[1].times[0]); // no line leads below a bias
  const std::string table = biasTable(result, s);
  EXPECT_NE(table.find("--max-bounces 2"), std::string::npos) << table;
  EXPECT_NE(table.find("-10.00 %"), std::string::npos) << table;
  EXPECT_NE(table.find("<td>10 %</td>"), std::string::npos) << table; // sqrt(0.01)
  EXPECT_EQ(table.find("<td>a</td>"), std::string::npos) << table;
  EXPECT_EQ(biasTable(resultOf({{"a", {lawfulRun(0.8, 0.5, 6)}}}), {s[0]}), "");
}

TEST(Remarks, TellWhenATargetWouldBeReached) {
  StudyResult result = resultOf({{"near", {lawfulRun(0.8, 0.5, 6)}},
                                 {"far", {lawfulRun(800.0, 0.5, 6)}},
                                 {"never", {biasedRun(), biasedRun()}},
                                 {"met", {lawfulRun(0.0008, 0.5, 6)}}});
  result.targetError = 0.07; // of "near" after 0.4 / 0.0049 s
  const auto lines = remarks(result, summarise(result));
  ASSERT_EQ(lines.size(), 4U); // and the bias
  EXPECT_EQ(lines[0], "near: the target, 7 %, was not reached; by its slope it would be after about 82 s.");
  EXPECT_EQ(lines[1], "far: the target, 7 %, was not reached; it would take more than 27 min.");
  EXPECT_EQ(lines[2], "never: the target, 7 %, was not reached, and may never be: a bias remains.");
  EXPECT_EQ(errorLevels(result).size(), 4U);
}

TEST(Ablation, IsAgainstTheWhole) {
  SettingSummary whole, rest;
  whole.secondsPerFrame = 0.4;
  whole.energy.value = 0.25; // a reference that was too dark by chance
  rest.secondsPerFrame = 0.3;
  rest.energy.value = -0.5;
  EXPECT_NEAR(ablationOf(whole, rest).timeSaved, 0.25, 1e-12);
  EXPECT_NEAR(ablationOf(whole, rest).energyLost, 0.6, 1e-12);
}

TEST(Csv, HasALineForEveryPoint) {
  const std::string csv = resultsCsv(resultOf({{"split=1, \"a\"", {lawfulRun(0.5, 0.25, 2)}}}));
  EXPECT_EQ(csv, "setting,seed,frames,seconds,mse,relMse,predictedRelMse\n"
                 "\"split=1, \"\"a\"\"\",0,1,0.25,0.5,0.5,0\n"
                 "\"split=1, \"\"a\"\"\",0,2,0.5,0.25,0.25,0.25\n");
}

} // namespace
} // namespace vkpt
