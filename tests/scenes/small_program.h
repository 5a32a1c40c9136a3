#pragma once
// A compute shader of one work-group, an input and an output: storage buffers at bindings 0 and 1.

#include "gpu/compute_pipeline.h"

#include <span>

namespace vkpt::test {

void runSmallProgram(std::span<const std::uint32_t> spirv, const gpu::SpecialisationMap& constants,
                     std::span<const std::byte> input, std::span<std::byte> output);

} // namespace vkpt::test
