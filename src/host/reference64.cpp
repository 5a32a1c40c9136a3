#include "host/program64.h"

namespace vkpt {

HostRender renderHost64(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                        const HostSettings& settings, std::uint64_t frames, unsigned threads) {
  const auto make = [&] { return host64::makeProgram(scene, source, effects, settings); };
  return host64::renderWith(make, settings.width, settings.height, frames, threads);
}

Replay replay64(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                const HostSettings& settings, int x, int y, std::uint64_t sample) {
  auto program = host64::makeProgram(scene, source, effects, settings);
  return host64::replayWith(program, x, y, sample);
}

} // namespace vkpt
