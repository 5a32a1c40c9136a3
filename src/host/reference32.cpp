#include "host/program32.h"

namespace vkpt {

HostRender renderHost32(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                        const HostSettings& settings, std::uint64_t frames, unsigned threads) {
  const auto make = [&] { return host32::makeProgram(scene, source, effects, settings); };
  return host32::renderWith(make, settings.width, settings.height, frames, threads);
}

Replay replay32(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                const HostSettings& settings, int x, int y, std::uint64_t sample) {
  auto program = host32::makeProgram(scene, source, effects, settings);
  return host32::replayWith(program, x, y, sample);
}

} // namespace vkpt
