#include "device/camera_frame.h"
#include "host/program64.h"

namespace vkpt {

namespace {

host64::Program<RuntimeEffects> makeProgram(const PackedScene& scene, const Scene& source,
                                            const EffectSet& effects, const HostSettings& settings) {
  return {scene,
          frameConstants(source, scene.lightChoice, settings.estimator, settings.width, settings.height,
                         settings.seed),
          effects, settings.estimator.roulette, source.filter.shape};
}

} // namespace

HostRender renderHost64(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                        const HostSettings& settings, std::uint64_t frames, unsigned threads) {
  const auto make = [&] { return makeProgram(scene, source, effects, settings); };
  return host64::renderWith(make, settings.width, settings.height, frames, threads);
}

Replay replay64(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                const HostSettings& settings, int x, int y, std::uint64_t sample) {
  auto program = makeProgram(scene, source, effects, settings);
  return host64::replayWith(program, x, y, sample);
}

} // namespace vkpt
