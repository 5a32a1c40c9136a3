#pragma once
// The preview's own shaders, embedded in its binary.

#include "spirv.h"

namespace vkpt::spirv {

extern const std::span<const std::uint32_t> kDisplay; ///< display.comp
extern const std::span<const std::uint32_t> kPrimary; ///< path.comp, built with VKPT_PRIMARY

} // namespace vkpt::spirv
