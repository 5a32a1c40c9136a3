#pragma once
// A compute shader with an input and an output, both storage buffers.

#include "gpu/compute_pipeline.h"

#include <span>

namespace vkpt::selftest {

struct SmallProgram {
  std::span<const std::uint32_t> spirv;
  gpu::SpecialisationMap constants{};
  std::uint32_t firstBinding = 0; ///< of the input; the output's is the next
  std::uint32_t groups = 1;
  std::uint32_t repeats = 1; ///< dispatches one after the other, which find what the last one wrote
};
/// The output is 0 at first.
void runSmallProgram(const gpu::Context& context, const SmallProgram& program,
                     std::span<const std::byte> input, std::span<std::byte> output);

} // namespace vkpt::selftest
