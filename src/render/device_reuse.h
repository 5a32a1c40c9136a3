#pragma once
#include "gpu/compute_pipeline.h"

namespace vkpt {

/// Paths that pixels share, in device memory, and the steps of path.comp that share them; dummies unless they are wanted.
class DeviceReuse {
public:
  /// pathShader, constants: of the paths' kernel. edge: of the squares of pixels; 1: none are wanted.
  DeviceReuse(const gpu::Context& context, const gpu::BindingSet& bindings,
              std::span<const std::uint32_t> pathShader, const gpu::SpecialisationMap& constants,
              std::uint32_t edge, bool lightTree);
  [[nodiscard]] bool wanted() const { return m_edge > 1; }
  [[nodiscard]] std::uint32_t pixels() const { return m_edge * m_edge; }
  /// shared::kStepFirstVertices, ...; only if wanted.
  [[nodiscard]] const gpu::ComputePipeline& step(std::uint32_t step) const { return m_steps[step - 1]; }
  /// Room for so many slots and samples of each, bound. Throws DeviceError when the device has none.
  void reserve(const gpu::Context& context, const gpu::BindingSet& bindings, std::uint32_t slots,
               std::uint32_t samples);

  /// Of paths and connections, for so many slots and samples of each.
  [[nodiscard]] static std::uint64_t pathBytes(std::uint64_t slots, std::uint64_t samples, bool lightTree);
  [[nodiscard]] static std::uint64_t connectionBytes(std::uint64_t slots, std::uint64_t samples,
                                                     std::uint32_t edge);

private:
  std::uint32_t m_edge;
  bool m_lightTree;
  std::uint64_t m_places = 0; ///< slots times samples that there is room for
  gpu::TexelBuffer m_paths;
  gpu::TexelBuffer m_connections;
  std::vector<gpu::ComputePipeline> m_steps;
};

} // namespace vkpt
