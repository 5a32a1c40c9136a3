#include "device/camera_frame.h"
#include "host/program32.h"

namespace vkpt {

HostRender renderHost32(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                        const HostSettings& settings, std::uint64_t frames, unsigned threads) {
  const shared::FrameConstants constants = frameConstants(source, scene.lightChoice, settings.estimator,
                                                          settings.width, settings.height, settings.seed);
  const auto makeProgram = [&] {
    return host32::Program<RuntimeEffects>(scene, constants, effects, settings.estimator.roulette,
                                           source.filter.shape);
  };
  return host32::renderWith(makeProgram, settings.width, settings.height, frames, threads);
}

} // namespace vkpt
