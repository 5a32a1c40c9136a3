#include "selftest/settings.h"

#include "core/hash.h"

namespace vkpt::selftest {

std::uint32_t seedOf(const std::string& name) {
  const std::uint64_t hash = hashText(name);
  return static_cast<std::uint32_t>(hash ^ (hash >> 32U));
}

EstimatorSettings bsdfSampling(RouletteMode roulette) {
  EstimatorSettings s;
  s.light = LightStrategy::Bsdf;
  s.roulette = roulette;
  return s;
}

EstimatorSettings lightSampling() {
  EstimatorSettings s;
  s.light = LightStrategy::Nee;
  return s;
}

EstimatorSettings misSampling() {
  EstimatorSettings s;
  s.light = LightStrategy::Mis;
  return s;
}

EstimatorSettings withoutRoulette(EstimatorSettings settings) {
  settings.rouletteAfter = kUnlimitedBounces - 1;
  return settings;
}

EstimatorSettings withBounces(EstimatorSettings settings, std::uint32_t bounces) {
  settings.maxBounces = bounces;
  return settings;
}

EffectSet everyEffect() { return EffectSet::all(); }

} // namespace vkpt::selftest
