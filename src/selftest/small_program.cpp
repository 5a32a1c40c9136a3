#include "selftest/small_program.h"

#include <algorithm>

namespace vkpt::selftest {

namespace {

void dispatchRepeatedly(const gpu::Context& context, const gpu::ComputePipeline& pipeline,
                        const gpu::BindingSet& bindings, std::uint32_t groups, std::uint32_t times) {
  constexpr auto kCompute = vk::PipelineStageFlagBits::eComputeShader;
  constexpr auto kWritten = vk::AccessFlagBits::eShaderWrite;
  context.execute([&](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline.handle());
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, bindings.pipelineLayout(), 0, bindings.set(),
                                {});
    const vk::MemoryBarrier between(kWritten, vk::AccessFlagBits::eShaderRead | kWritten);
    for (std::uint32_t i = 0; i < times; ++i) {
      commands.dispatch(groups, 1, 1);
      commands.pipelineBarrier(kCompute, kCompute, {}, between, {}, {});
    }
    const vk::MemoryBarrier toHost(kWritten, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(kCompute, vk::PipelineStageFlagBits::eHost, {}, toHost, {}, {});
  });
}

} // namespace

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
  constexpr std::uint32_t kMostAtOnce = 64; // a submission of seconds looks like a hang to some drivers
  for (std::uint32_t done = 0; done < program.repeats; done += kMostAtOnce)
    dispatchRepeatedly(context, pipeline, bindings, program.groups,
                       std::min(program.repeats - done, kMostAtOnce));
  out.read(context, output);
}

} // namespace vkpt::selftest
