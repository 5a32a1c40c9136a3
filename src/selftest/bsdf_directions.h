#pragma once
#include "scene/nori_tests.h"
#include "selftest/outcome.h"

#include <cstdint>

namespace vkpt {

/// Throws SceneError where a BSDF of the test has no density.
void checkDensities(const NoriChi2Test& test);

/// Do sampled directions follow the density that light sampling is weighted with? For each BSDF from random
/// directions, of the rough glass half from behind. Samples of weight 0 have a cell of their own, beside
/// Nori's.
void testBsdfDirections(const NoriChi2Test& test, std::uint32_t seed, const TellOutcome& tell);

} // namespace vkpt
