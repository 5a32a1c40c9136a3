#pragma once
// Sets of effects that leave no pair of them untried.

#include "device/effects.h"

#include <vector>

namespace vkpt::test {

/// Few sets in which every two effects occur both together, one without the other, and neither: a covering
/// array of strength 2, as small as can be (Katona 1973; Kleitman and Spencer 1973). Effect number e is in
/// set i where bit i is set in the e-th number with half of its bits set.
std::vector<EffectSet> pairwiseSets();

/// Renders a pixel or two of a scene that has everything with a kernel of exactly these effects. Returns what
/// went wrong; empty: nothing did.
std::string tryKernel(const EffectSet& effects);

} // namespace vkpt::test
