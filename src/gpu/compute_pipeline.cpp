#include "gpu/compute_pipeline.h"

#include "core/error.h"
#include "core/hash.h"

#include <fmt/format.h>

namespace vkpt::gpu {

BindingSet::BindingSet(const Context& context, std::span<const BindingLayout> bindings,
                       std::uint32_t pushConstantBytes) {
  std::vector<vk::DescriptorSetLayoutBinding> layout;
  std::vector<vk::DescriptorPoolSize> sizes;
  std::vector<std::uint32_t> words{pushConstantBytes};
  for (const auto& b : bindings) {
    layout.emplace_back(b.binding, b.type, b.count, vk::ShaderStageFlagBits::eCompute);
    sizes.emplace_back(b.type, b.count);
    words.insert(words.end(), {b.binding, static_cast<std::uint32_t>(b.type), b.count});
  }
  m_layoutKey = hashBytes(std::as_bytes(std::span<const std::uint32_t>(words)));
  m_layout = vk::raii::DescriptorSetLayout(context.device(), {{}, layout});
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, pushConstantBytes);
  m_pipelineLayout = vk::raii::PipelineLayout(context.device(), {{}, *m_layout, push});
  m_pool = vk::raii::DescriptorPool(context.device(),
                                    {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes});
  m_sets = vk::raii::DescriptorSets(context.device(), {*m_pool, *m_layout});
}

void BindingSet::bind(const Context& context, std::uint32_t binding, const TexelBuffer& texels,
                      std::uint32_t element) const {
  const vk::BufferView view = texels.view();
  context.device().updateDescriptorSets(vk::WriteDescriptorSet(set(), binding, element, 1,
                                                               vk::DescriptorType::eStorageTexelBuffer,
                                                               nullptr, nullptr, &view),
                                        {});
}

void BindingSet::bind(const Context& context, std::uint32_t binding, const Buffer& buffer,
                      vk::DescriptorType type, std::uint32_t element) const {
  const vk::DescriptorBufferInfo info(buffer.handle(), 0, buffer.bytes());
  context.device().updateDescriptorSets(
      vk::WriteDescriptorSet(set(), binding, element, 1, type, nullptr, &info, nullptr), {});
}

ComputePipeline::ComputePipeline(const Context& context, std::span<const std::uint32_t> spirv,
                                 const BindingSet& bindings, const SpecialisationMap& constants) {
  const std::uint64_t key = pipelineKey(context, spirv, constants);
  const std::uint64_t layoutKey = bindings.layoutKey();
  const std::uint64_t madeKey = hashBytes(std::as_bytes(std::span(&layoutKey, 1)), key);
  m_pipeline = context.madePipelines().find(madeKey);
  if (m_pipeline)
    return;
  const std::vector<std::uint32_t> code = specialised(spirv, constants);
  try {
    const vk::raii::ShaderModule module(context.device(),
                                        {{}, code.size() * sizeof(std::uint32_t), code.data()});
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
    const PipelineCache cache(context, key);
    const vk::ComputePipelineCreateInfo info({}, stage, bindings.pipelineLayout());
    m_pipeline = std::make_shared<vk::raii::Pipeline>(context.device(), cache.handle(), info);
    cache.save();
    context.madePipelines().keep(madeKey, m_pipeline);
  } catch (const vk::SystemError& e) {
    throw DeviceError(
        fmt::format("{}: the compute pipeline could not be made: {}", context.info().name, e.what()));
  }
}

} // namespace vkpt::gpu
