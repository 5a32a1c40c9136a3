#pragma once
#include "gpu/compute_pipeline.h"

namespace vkpt {

/// Blocks worked on at once where paths are shared, which takes 4 to 7 kB a slot.
inline constexpr std::uint32_t kMostSharedBlocks = 256;

/// Paths that pixels share, in device memory, and the kernels that share them; dummies unless they are
/// wanted.
class DeviceReuse {
public:
  /// first_vertices.comp and share_paths.comp.
  struct Shaders {
    std::span<const std::uint32_t> firstVertices;
    std::span<const std::uint32_t> sharePaths;
  };
  /// constants: of the paths' kernel. edge: of the squares of pixels; 1: none are wanted.
  DeviceReuse(const gpu::Context& context, const gpu::BindingSet& bindings, const Shaders& shaders,
              const gpu::SpecialisationMap& constants, std::uint32_t edge, bool lightTree);
  [[nodiscard]] bool wanted() const { return m_edge > 1; }
  [[nodiscard]] std::uint32_t pixels() const { return m_edge * m_edge; }
  /// Only if wanted.
  [[nodiscard]] vk::Pipeline firstVertices() const { return m_kernels.back().handle(); }
  /// shared::kStepConnect, ...; only if wanted.
  [[nodiscard]] vk::Pipeline step(std::uint32_t step) const { return m_kernels[step].handle(); }
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
  std::vector<gpu::ComputePipeline> m_kernels; ///< the steps in their order, then the first vertices
};

} // namespace vkpt
