#include "selftest/small_program.h"

namespace vkpt::selftest {

void runSmallProgram(const gpu::Context& context, const SmallProgram& program,
                     std::span<const std::byte> input, std::span<std::byte> output) {
  using vk::DescriptorType;
  const std::uint32_t first = program.firstBinding;
  const gpu::BindingLayout layout[] = {{first, DescriptorType::eStorageBuffer},
                                       {first + 1, DescriptorType::eStorageBuffer}};
  const gpu::BindingSet bindings(context, layout, sizeof(std::uint32_t));
  const gpu::ComputePipeline pipeline(context, program.spirv, bindings, program.constants);
  const auto usage = vk::BufferUsageFlagBits::eStorageBuffer;
  const gpu::Buffer in(context, "input", input.size(), usage, gpu::MemoryKind::Host);
  const gpu::Buffer out(context, "output", output.size(), usage, gpu::MemoryKind::Host);
  in.write(context, input);
  out.fillZero(context);
  bindings.bind(context, first, in, DescriptorType::eStorageBuffer);
  bindings.bind(context, first + 1, out, DescriptorType::eStorageBuffer);
  context.execute([&](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline.handle());
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, bindings.pipelineLayout(), 0, bindings.set(),
                                {});
    const auto written = vk::AccessFlagBits::eShaderWrite;
    const vk::MemoryBarrier between(written, vk::AccessFlagBits::eShaderRead | written);
    for (std::uint32_t i = 0; i < program.repeats; ++i) {
      commands.dispatch(program.groups, 1, 1);
      commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader,
                               vk::PipelineStageFlagBits::eComputeShader, {}, between, {}, {});
    }
    const vk::MemoryBarrier toHost(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {},
                             toHost, {}, {});
  });
  out.read(context, output);
}

} // namespace vkpt::selftest
