#pragma once
// Compute pipelines and the descriptor set they share.

#include "gpu/buffer.h"
#include "gpu/pipeline_cache.h"

#include <span>
#include <vector>

namespace vkpt::gpu {

struct BindingLayout {
  std::uint32_t binding;
  vk::DescriptorType type;
  std::uint32_t count = 1;
};

/// One descriptor set with its layout and pool.
class BindingSet {
public:
  BindingSet(const Context& context, std::span<const BindingLayout> bindings,
             std::uint32_t pushConstantBytes);

  void bind(const Context& context, std::uint32_t binding, const TexelBuffer& texels,
            std::uint32_t element = 0) const;
  void bind(const Context& context, std::uint32_t binding, const Buffer& buffer, vk::DescriptorType type,
            std::uint32_t element = 0) const;

  [[nodiscard]] vk::PipelineLayout pipelineLayout() const { return *m_pipelineLayout; }
  /// Equal for sets of the same layout: a pipeline made for one serves the others.
  [[nodiscard]] std::uint64_t layoutKey() const { return m_layoutKey; }
  [[nodiscard]] vk::DescriptorSet set() const { return *m_sets[0]; }

private:
  std::uint64_t m_layoutKey = 0;
  vk::raii::DescriptorSetLayout m_layout = nullptr;
  vk::raii::PipelineLayout m_pipelineLayout = nullptr;
  vk::raii::DescriptorPool m_pool = nullptr;
  vk::raii::DescriptorSets m_sets = nullptr;
};

class ComputePipeline {
public:
  ComputePipeline(const Context& context, std::span<const std::uint32_t> spirv, const BindingSet& bindings,
                  const SpecialisationMap& constants);
  [[nodiscard]] vk::Pipeline handle() const { return **m_pipeline; }

private:
  MadePipelines::Pipeline m_pipeline;
};

} // namespace vkpt::gpu
