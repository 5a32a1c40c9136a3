#include "calibration/calibration.h"

#include "core/hash.h"
#include "device/effects.h"
#include "render/render_loop.h"
#include "scene/load.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vkpt::test {
namespace {

double square(double x) { return x * x; }

/// The films' common mean.
std::vector<Vec3d> meanOf(const std::vector<Film>& films) {
  std::vector<Vec3d> mean(films.front().pixels.size(), Vec3d(0.0));
  for (const Film& film : films) {
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += film.pixels[i].mean / static_cast<double>(films.size());
  }
  return mean;
}

double imageRatio(const std::vector<Film>& films, const std::vector<Vec3d>& mean) {
  double m = 0.0;
  for (const Vec3d& b : mean)
    m += (b.x + b.y + b.z) / (3.0 * static_cast<double>(mean.size()));
  const auto n = static_cast<double>(films.size());
  double measured = 0.0, predicted = 0.0;
  for (const Film& film : films) {
    predicted += square(filmStatistics(film).relativeError) / n;
    for (std::size_t i = 0; i < mean.size(); ++i)
      for (int c = 0; c < 3; ++c)
        measured += square(film.pixels[i].mean[c] - mean[i][c]) / (square(mean[i][c]) + square(0.01 * m)) /
                    (3.0 * static_cast<double>(mean.size()) * (n - 1.0));
  }
  return std::sqrt(measured / predicted);
}

Vec3d meanScatter(const std::vector<Film>& films) {
  const auto n = static_cast<double>(films.size());
  Vec3d mean(0.0), variance(0.0), squares(0.0);
  for (const Film& film : films) {
    const FilmStatistics s = filmStatistics(film);
    mean += s.mean / n;
    variance += s.standardError * s.standardError / n;
  }
  for (const Film& film : films) {
    const Vec3d d = filmStatistics(film).mean - mean;
    squares += d * d;
  }
  return squares / variance;
}

} // namespace

const gpu::Context& sharedContext() {
  static const gpu::Context context({"", true, {}});
  return context;
}

StudySetting settingOf(const Scene& scene, const EstimatorSettings& estimator) {
  StudySetting setting;
  setting.estimator = estimator;
  setting.filter = scene.filter;
  setting.effects = detectEffects(scene, setting.estimator);
  return setting;
}

Scene sceneOf(const std::string& name, int width, int height) {
  const fs::path path = name.ends_with(".xml") ? fs::path(VKPT_SOURCE_DIR) / "assets" / name : fs::path(name);
  SceneReport report;
  Scene scene = loadScene({&path, 1}, report);
  scene.width = width;
  scene.height = height;
  return scene;
}

SeedRuns::SeedRuns(const Scene& scene, const EstimatorSettings& estimator)
    : m_run(sharedContext(), scene, settingOf(scene, estimator)) {}

Film SeedRuns::render(std::uint32_t seed, std::uint64_t frames) {
  m_run.restart(seed);
  while (!m_run.finished(frames, std::nullopt))
    m_run.step(frames, std::nullopt);
  return m_run.film();
}

Film SeedRuns::renderTo(std::uint32_t seed, double targetError) {
  m_run.integrator().restart(seed);
  RenderJob job;
  job.targetError = targetError;
  RenderObserver observer;
  Film film;
  const RenderResult result = renderUntil(m_run.integrator(), film, job, observer);
  EXPECT_EQ(result.stop, StopReason::Error);
  return film;
}

Calibration calibrationOf(const std::vector<Film>& films) {
  Calibration c;
  c.seeds = films.size();
  c.samples = films.front().pixels.front().count;
  const std::vector<Vec3d> mean = meanOf(films);
  c.imageRatio = imageRatio(films, mean);
  c.meanScatter = meanScatter(films);
  const auto n = static_cast<double>(films.size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    double scatter = 0.0, predicted = 0.0;
    for (const Film& film : films) {
      scatter += square(film.pixels[i].mean.y - mean[i].y) / (n - 1.0);
      predicted += film.pixels[i].varianceOfMean().y / n;
    }
    if (predicted > 0.0) // else nothing is seen there
      c.pixelRatios.push_back(scatter / predicted);
  }
  return c;
}

double fitProbability(const std::vector<double>& values, const std::function<double(double)>& cdf,
                      int cells) {
  std::vector<double> counts(static_cast<std::size_t>(cells), 0.0);
  for (const double v : values)
    counts[static_cast<std::size_t>(std::min(cells - 1, static_cast<int>(cdf(v) * cells)))] += 1.0;
  const double expected = static_cast<double>(values.size()) / cells;
  double statistic = 0.0;
  for (const double count : counts)
    statistic += square(count - expected) / expected;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(cells - 1.0), statistic));
}

std::uint32_t seedOfTest() {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::uint64_t hash = hashText(std::string(test.test_suite_name()) + "." + test.name());
  return static_cast<std::uint32_t>(hash ^ (hash >> 32U));
}

} // namespace vkpt::test
