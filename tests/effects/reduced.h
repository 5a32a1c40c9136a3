#pragma once
// The SPIR-V of a kernel for a set of effects without what is never reached.

#include "device/effects.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vkpt::test {

using Spirv = std::vector<std::uint32_t>;

/// Effects by id, so that a shader may have more of them than the program.
using EffectIds = std::vector<std::uint32_t>;
EffectIds idsOf(const EffectSet& set);

/// With these effects on and all others off: branches that are never taken and functions that are never
/// called removed (spirv-opt's passes), ids renumbered, valid. Throws std::runtime_error where it is not.
Spirv reduced(std::span<const std::uint32_t> kernel, const EffectIds& on);

} // namespace vkpt::test
