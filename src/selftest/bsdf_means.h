#pragma once
#include "scene/nori_tests.h"
#include "selftest/outcome.h"

#include <cstdint>

namespace vkpt {

/// The mean luminance of the sample weights of each BSDF, seen from each angle, against its reference.
void testBsdfMeans(const NoriTTest& test, std::uint32_t seed, const TellOutcome& tell);

} // namespace vkpt
