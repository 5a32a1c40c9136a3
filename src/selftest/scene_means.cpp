#include "selftest/scene_means.h"

#include "selftest/film_mean.h"
#include "selftest/render_scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace vkpt {
namespace {

/// As few samples as give every pixel a variance.
constexpr std::uint64_t kLeastFrames = 2;

} // namespace

void testSceneMeans(const NoriTTest& test, const gpu::Context& context,
                    const std::function<EstimatorSettings(const Scene&)>& estimatorOf, std::uint32_t seed,
                    const TellOutcome& tell) {
  const double level = sidakLevel(test.significanceLevel, test.references.size());
  for (std::size_t i = 0; i < test.scenes.size(); ++i) {
    Scene scene = test.scenes[i];
    std::tie(scene.width, scene.height) = sizeForSamples(scene.width, scene.height, test.sampleCount);
    scene.filter = {};
    const auto pixels = static_cast<std::uint64_t>(scene.width) * static_cast<std::uint64_t>(scene.height);
    const std::uint64_t frames =
        std::max(kLeastFrames, (static_cast<std::uint64_t>(test.sampleCount) + pixels - 1) / pixels);
    const selftest::Rendered rendered = selftest::renderScene(context, scene,
                                                              {.estimator = estimatorOf(scene),
                                                               .width = scene.width,
                                                               .height = scene.height,
                                                               .frames = frames,
                                                               .seed = seed + static_cast<std::uint32_t>(i)});
    const MeanEstimate mean = meanLuminance(rendered.film);
    TestStatistic statistic = studentTest(mean, test.references[i]);
    if (rendered.counters.faults() > 0)
      statistic.why = fmt::format("{} faults", rendered.counters.faults());
    tell({test.where, fmt::format("scene {}", i + 1),
          fmt::format("mean {:.6g}, reference {:g}, {} samples", mean.mean, test.references[i],
                      frames * pixels),
          statistic, level});
  }
}

} // namespace vkpt
