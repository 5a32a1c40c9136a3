#include "calibration/calibration_checks.h"

#include "study/reference.h"
#include "study/run_study.h"
#include "study/study_analysis.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vkpt::test {
namespace {

constexpr double kAlpha = 1e-3; // probability that a check fails by chance
constexpr int kCells = 10;      // of the test of the pixels' distribution

/// Two-sided.
double probabilityOf(double chiSquare, double degrees) {
  const boost::math::chi_squared law(degrees);
  const double below = boost::math::cdf(law, chiSquare);
  return 2.0 * std::min(below, 1.0 - below);
}

} // namespace

void expectCalibrated(const Scene& scene, std::uint32_t seeds, std::uint64_t frames,
                      const EstimatorSettings& estimator) {
  SeedRuns runs(scene, estimator);
  std::vector<Film> films;
  for (std::uint32_t i = 0; i < seeds; ++i)
    films.push_back(runs.render(seedOfTest() + i, frames));
  const Calibration c = calibrationOf(films);
  const double independent = estimator.sampler == Sampler::Sobol
                                 ? shared::kReplicates
                                 : static_cast<double>(frames); // whose scatter is measured
  const boost::math::fisher_f law(seeds - 1.0, seeds * (independent - 1.0));
  const double fit = fitProbability(
      c.pixelRatios, [&law](double ratio) { return boost::math::cdf(law, ratio); }, kCells);
  fmt::print(
      "{}, {} seeds, {} frames: relative error {:.2f} %, measured / predicted {:.3f}; pixels: p {:.3g}\n",
      scene.name, seeds, frames, 100.0 * filmStatistics(films.front()).relativeError, c.imageRatio, fit);
  EXPECT_GT(c.imageRatio, 0.9);
  EXPECT_LT(c.imageRatio, 1.1);
  if (estimator.lightTracing == LightTracing::Off) {
    EXPECT_GT(c.pixelRatios.size(), 20U * kCells / 2U); // ten expected in a cell and more
    EXPECT_GT(fit, kAlpha);
  }
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_GT(probabilityOf(c.meanScatter[channel], seeds - 1.0), kAlpha / 3.0) << c.meanScatter[channel];
}

void expectTargetKept(const Scene& scene, double target, std::uint32_t seeds, std::uint64_t referenceFrames,
                      const EstimatorSettings& estimator) {
  SeedRuns runs(scene, estimator);
  const Reference reference(runs.render(~seedOfTest(), referenceFrames));
  EXPECT_LT(reference.noise().relMse, 0.1 * target * target) << "the reference would decide";
  std::uint32_t kept = 0;
  double worst = 0.0;
  for (std::uint32_t i = 0; i < seeds; ++i) {
    const Film film = runs.renderTo(seedOfTest() + i, target);
    const double error = std::sqrt(std::max(0.0, reference.measure(film).relMse - reference.noise().relMse));
    kept += error <= 1.1 * target ? 1U : 0U;
    worst = std::max(worst, error / target);
  }
  fmt::print("{}, target {:g} %: kept in {} of {} seeds, at worst {:.3f} times it\n", scene.name,
             100.0 * target, kept, seeds, worst);
  EXPECT_GE(10 * kept, 9 * seeds);
}

void expectSlopeOfIndependentSamples(const Scene& scene, std::uint32_t seeds, std::uint64_t frames,
                                     SlopeOver over) {
  StudyPlan plan;
  plan.settings.push_back(settingOf(scene));
  plan.reference = plan.settings.front();
  plan.seeds = seeds;
  plan.firstSeed = seedOfTest();
  plan.frames = frames;
  const StudyResult result =
      runStudy(sharedContext(), scene, plan, [](const StudyProgress&) { return true; });
  const SettingSummary s = summarise(result).front();
  const double bound = boost::math::quantile(
      boost::math::complement(boost::math::students_t(seeds - 1.0), 0.5 * kAlpha)); // of its standard errors
  std::vector slopes{s.slopeOverFrames};
  if (over == SlopeOver::framesAndTime)
    slopes.push_back(s.slopeOverTime);
  for (const auto& slope : slopes) {
    ASSERT_TRUE(slope && slope->standardError);
    fmt::print("{}: slope {:.3f} ± {:.3f}\n", scene.name, slope->value, *slope->standardError);
    EXPECT_LT(*slope->standardError, 0.1);
    EXPECT_LT(std::abs(slope->value + 1.0), bound * *slope->standardError);
  }
}

} // namespace vkpt::test
