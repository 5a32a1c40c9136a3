#pragma once
// A kernel with the values of its specialisation constants.

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace vkpt::gpu {

/// Values of specialisation constants by id; booleans are 0 or 1.
using SpecialisationMap = std::map<std::uint32_t, std::uint32_t>;

/// The SPIR-V module in which the scalar specialisation constants are constants of these values, or of their
/// defaults, and so are the operations on them that our shaders have (SPIR-V 1.5, 3.32.7); others stay as
/// they are. Values whose ids the module lacks count for nothing.
///
/// Drivers do the same with VkSpecializationInfo. The validation layer does it, too, and then checks what
/// came out, for each pipeline, in more time than the driver takes to compile; of modules it keeps on disk
/// which ones it has found valid.
std::vector<std::uint32_t> specialised(std::span<const std::uint32_t> spirv, const SpecialisationMap& values);

} // namespace vkpt::gpu
