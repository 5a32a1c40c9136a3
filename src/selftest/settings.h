#pragma once
// How the checks sample and what they are seeded by. Needs no device.

#include "device/effects.h"

#include <string>

namespace vkpt::selftest {

/// Hash of a name: the seed of a check, or of one of several renders in it.
std::uint32_t seedOf(const std::string& name);

EstimatorSettings bsdfSampling(RouletteMode roulette = RouletteMode::Throughput);
EstimatorSettings lightSampling();
EstimatorSettings misSampling();
/// Roulette never ends a path within any number of bounces that a test's scene allows.
EstimatorSettings withoutRoulette(EstimatorSettings settings);
EstimatorSettings withBounces(EstimatorSettings settings, std::uint32_t bounces);
/// Every effect there is, whatever the scene calls for.
EffectSet everyEffect();

} // namespace vkpt::selftest
