#pragma once
// Many seeds of one scene: what they differ by, against what each of them says of its own error.

#include "film/film.h"
#include "scene/scene.h"
#include "study/setting_run.h"

#include <functional>
#include <string>
#include <vector>

namespace vkpt::test {

/// Made at the first call, with the validation layer on.
const gpu::Context& sharedContext();

/// The scene by this estimator.
StudySetting settingOf(const Scene& scene, const EstimatorSettings& estimator = {});

/// A built-in scene or a file of assets/, at a size of its own.
Scene sceneOf(const std::string& name, int width, int height);

/// The scene with the default estimator and a sampler on a validated device, seed after seed.
class SeedRuns {
public:
  explicit SeedRuns(const Scene& scene, const EstimatorSettings& estimator = {});
  /// So many frames with this seed.
  Film render(std::uint32_t seed, std::uint64_t frames);
  /// Until the upper 95 % bound of the relative error is at most this, by the rule of renderUntil().
  Film renderTo(std::uint32_t seed, double targetError);

private:
  SettingRun m_run;
};

/// Over independent films of one scene.
struct Calibration {
  std::size_t seeds = 0;
  std::uint64_t samples = 0; ///< of a pixel, each
  /// sqrt(relMSE) of the films against their common mean, n / (n - 1) times, over what they predict
  /// (`error.relative`).
  double imageRatio = 0.0;
  /// The scatter of the films' mean radiance, sum of squares over its predicted variance, by channel: of
  /// chi-square with seeds - 1 degrees of freedom.
  Vec3d meanScatter{0.0};
  /// For every pixel and the green channel: sample variance of the films' values over the mean of their
  /// squared standard errors; of F with seeds - 1 and seeds (samples - 1) degrees where samples are normal
  /// and independent.
  std::vector<double> pixelRatios;
};
Calibration calibrationOf(const std::vector<Film>& films);

/// Of Pearson's chi-square over `cells` cells of equal probability, that `values` are of this distribution.
double fitProbability(const std::vector<double>& values, const std::function<double(double)>& cdf, int cells);

/// Hash of the running test's name.
std::uint32_t seedOfTest();

} // namespace vkpt::test
