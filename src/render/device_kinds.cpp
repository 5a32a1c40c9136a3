#include "render/device_kinds.h"

#include "core/error.h"
#include "shared/structs.h"

#include <fmt/format.h>

namespace vkpt {

using namespace shared;

DeviceKinds::DeviceKinds(const gpu::Context& context, int width, int height, bool wanted)
    : m_pixels(wanted ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height) : 1),
      m_wanted(wanted) {
  const std::uint64_t bytes = std::uint64_t{m_pixels} * kKindPlanes * sizeof(float);
  if (bytes > context.limits().maxStorageBufferRange) {
    throw UsageError(fmt::format("--output-paths at {}x{}: {} can do {} pixels at most", width, height,
                                 context.info().name,
                                 context.limits().maxStorageBufferRange / (kKindPlanes * sizeof(float))));
  }
  for (std::uint32_t i = 0; i < kKindCount; ++i) {
    m_images.emplace_back(context, "kind of light path", bytes, vk::BufferUsageFlagBits::eStorageBuffer,
                          gpu::MemoryKind::Device);
  }
  clear(context);
}

void DeviceKinds::resize(const gpu::Context& context, int width, int height) {
  if (m_wanted)
    *this = DeviceKinds(context, width, height, true);
}

void DeviceKinds::bind(const gpu::Context& context, const gpu::BindingSet& bindings) const {
  for (std::uint32_t i = 0; i < kKindCount; ++i)
    bindings.bind(context, kBindingKinds, m_images[i], vk::DescriptorType::eStorageBuffer, i);
}

void DeviceKinds::clear(const gpu::Context& context) const {
  for (const auto& image : m_images)
    image.fillZero(context);
}

std::vector<std::vector<Vec3d>> DeviceKinds::download(const gpu::Context& context,
                                                      std::span<const std::uint64_t> samples) const {
  if (!m_wanted)
    return {};
  std::vector<std::vector<Vec3d>> kinds;
  std::vector<float> values(m_pixels * kKindPlanes);
  for (const auto& image : m_images) {
    image.read(context, std::as_writable_bytes(std::span{values}));
    const auto at = [&](std::uint32_t plane, std::size_t pixel) {
      return static_cast<double>(values[plane * m_pixels + pixel]);
    };
    auto& kind = kinds.emplace_back(m_pixels);
    for (std::size_t i = 0; i < m_pixels; ++i) {
      for (std::uint32_t c = 0; c < 3; ++c) {
        const double sum = at(kKindOpen + c, i) + at(kKindClosed + 2 * c, i) + at(kKindClosed + 2 * c + 1, i);
        kind[i][static_cast<int>(c)] = samples[i] > 0 ? sum / static_cast<double>(samples[i]) : 0.0;
      }
    }
  }
  return kinds;
}

std::uint64_t DeviceKinds::bytes() const { return gpu::bytesOf(m_images); }

} // namespace vkpt
