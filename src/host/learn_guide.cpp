#include "host/learn_guide.h"

#include "accel/workers.h"
#include "device/guide.h"
#include "device/light_grid.h"
#include "device/light_tracing.h"
#include "host/program32.h"

#include <memory>

namespace vkpt {
namespace {

constexpr std::uint32_t kPathsInChunk = 4096;
constexpr std::uint32_t kChunks = 64;
constexpr std::uint32_t kGuideKey = 0x3C6EF372U; // random numbers that no render uses

} // namespace

void learnGuide(PackedScene& scene, const Scene& source, const EffectSet& effects,
                const EstimatorSettings& estimator, unsigned threads) {
  if (!effects.has(Effect::Guiding) || guidingObstacle(source, estimator))
    return;
  std::vector<std::vector<Photon>> found(kChunks);
  accel::Workers(threads).forEach(kChunks, [&](std::size_t chunk) {
    auto program = host32::makeProgram(scene, source, effects, {estimator, 1, 1, kGuideKey});
    for (std::uint32_t i = 0; i < kPathsInChunk; ++i) {
      if (const auto photon = program.tracePhoton(static_cast<std::uint32_t>(chunk) * kPathsInChunk + i))
        found[chunk].push_back(*photon);
    }
  });
  std::vector<Photon> photons;
  for (const auto& some : found)
    photons.insert(photons.end(), some.begin(), some.end());
  Guide guide = makeGuide(photons);
  scene.lightChoice.guide = guide.grid;
  scene.guide = std::move(guide.numbers);
}

void learnLights(PackedScene& scene, const Scene& source, const EffectSet& effects,
                 const EstimatorSettings& estimator, unsigned threads) {
  // Each thread has its own, which its functions share.
  const auto functions = [&] {
    const auto make = [&] { return host32::makeProgram(scene, source, effects, {estimator, 1, 1, 0}); };
    const auto program = std::make_shared<decltype(make())>(make());
    return LightGridFunctions{[program](std::uint32_t node, const Vec3f& p, const Vec3f& n) {
                                return program->lightImportance(program->lightNode(node), p, n);
                              },
                              [program](const Vec3f& n) { return program->lightGridSide(n); }};
  };
  makeLightGrid(scene, source, functions, threads);
}

void learnScene(PackedScene& scene, const Scene& source, const EffectSet& effects,
                const EstimatorSettings& estimator, unsigned threads) {
  learnLights(scene, source, effects, estimator, threads);
  learnGuide(scene, source, effects, estimator, threads);
}

PackedScene packGuided(const Scene& scene, const EstimatorSettings& estimator, const EffectSet& effects,
                       unsigned threads) {
  PackedScene packed = packScene(scene, estimator, effects, threads);
  learnScene(packed, scene, effects, estimator, threads);
  return packed;
}

} // namespace vkpt
