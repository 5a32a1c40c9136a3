#include "render/device_reuse.h"

#include "device/packed_scene.h"
#include "shared/structs.h"

#include <algorithm>

namespace vkpt {

using namespace shared;

DeviceReuse::DeviceReuse(const gpu::Context& context, const gpu::BindingSet& bindings, const Shaders& shaders,
                         const gpu::SpecialisationMap& constants, std::uint32_t edge, bool lightTree)
    : m_edge(edge), m_lightTree(lightTree) {
  reserve(context, bindings, 1, 1);
  if (!wanted())
    return;
  gpu::SpecialisationMap own = constants;
  for (const std::uint32_t step : {kStepConnect, kStepBalance, kStepAddUp}) {
    own[kConstantShareStep] = step;
    m_kernels.emplace_back(context, shaders.sharePaths, bindings, own);
  }
  m_kernels.emplace_back(context, shaders.firstVertices, bindings, constants);
}

void DeviceReuse::reserve(const gpu::Context& context, const gpu::BindingSet& bindings, std::uint32_t slots,
                          std::uint32_t samples) {
  const std::uint64_t places = std::uint64_t{slots} * samples;
  if (places <= m_places || (m_places > 0 && !wanted()))
    return;
  m_places = places;
  m_paths = gpu::TexelBuffer(context, "shared paths", pathBytes(slots, samples, m_lightTree) / sizeof(Texel));
  m_connections =
      gpu::TexelBuffer(context, "connections of shared paths",
                       connectionBytes(slots, samples, m_edge) / sizeof(float), vk::Format::eR32Uint);
  bindings.bind(context, kBindingReuse, m_paths);
  bindings.bind(context, kBindingConnections, m_connections);
}

std::uint64_t DeviceReuse::pathBytes(std::uint64_t slots, std::uint64_t samples, bool lightTree) {
  const std::uint32_t texels = kTexelsPerSharedPath + kTexelsPerBegunPath + (lightTree ? kVertexPlanes : 0U);
  return slots * samples * texels * sizeof(Texel);
}

std::uint64_t DeviceReuse::connectionBytes(std::uint64_t slots, std::uint64_t samples, std::uint32_t edge) {
  constexpr std::uint64_t kSmallestBuffer = 16;
  return std::max(kSmallestBuffer, slots * samples * edge * edge * sizeof(float));
}

} // namespace vkpt
