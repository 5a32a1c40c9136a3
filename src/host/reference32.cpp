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

HostPixel renderPixel32(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                        const HostSettings& settings, int x, int y, std::uint64_t samples) {
  EffectSet withKinds = effects;
  withKinds.set(Effect::PathKinds);
  withKinds.set(Effect::KindImages);
  withKinds.set(Effect::PathReuse, false);
  withKinds.set(Effect::LightTracing, false); // kinds are those of the eye's paths alone
  auto program = host32::makeProgram(scene, source, withKinds, settings);
  HostPixel pixel;
  program.samplePixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, samples, pixel.whole);
  for (std::size_t k = 0; k < pixel.kinds.size(); ++k)
    pixel.kinds[k] = program.kinds[k] / static_cast<double>(samples);
  return pixel;
}

} // namespace vkpt
