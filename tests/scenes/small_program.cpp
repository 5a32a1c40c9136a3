#include "scenes/small_program.h"

#include "scenes/render_fixture.h"

namespace vkpt::test {

void runSmallProgram(std::span<const std::uint32_t> spirv, const gpu::SpecialisationMap& constants,
                     std::span<const std::byte> input, std::span<std::byte> output) {
  using vk::DescriptorType;
  const gpu::Context& context = sharedContext();
  constexpr gpu::BindingLayout kLayout[] = {{0, DescriptorType::eStorageBuffer},
                                            {1, DescriptorType::eStorageBuffer}};
  const gpu::BindingSet bindings(context, kLayout, sizeof(std::uint32_t));
  const gpu::ComputePipeline pipeline(context, spirv, bindings, constants);
  const auto usage = vk::BufferUsageFlagBits::eStorageBuffer;
  const gpu::Buffer in(context, "input", input.size(), usage, gpu::MemoryKind::Host);
  const gpu::Buffer out(context, "output", output.size(), usage, gpu::MemoryKind::Host);
  in.write(context, input);
  out.fillZero(context);
  bindings.bind(context, 0, in, DescriptorType::eStorageBuffer);
  bindings.bind(context, 1, out, DescriptorType::eStorageBuffer);
  context.execute([&](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline.handle());
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, bindings.pipelineLayout(), 0, bindings.set(),
                                {});
    commands.dispatch(1, 1, 1);
    const vk::MemoryBarrier toHost(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {},
                             toHost, {}, {});
  });
  out.read(context, output);
}

} // namespace vkpt::test
