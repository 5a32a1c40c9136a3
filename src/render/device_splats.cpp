#include "render/device_splats.h"

namespace vkpt {

DeviceSplats::DeviceSplats(const gpu::Context& context, int width, int height, bool wanted)
    : m_wanted(wanted),
      m_numbers(context, "splats", wanted ? texelsFor(width, height) : 4, vk::Format::eR32Uint) {
  clear(context);
}

void DeviceSplats::resize(const gpu::Context& context, int width, int height) {
  if (m_wanted)
    *this = DeviceSplats(context, width, height, true);
}

void DeviceSplats::bind(const gpu::Context& context, const gpu::BindingSet& bindings,
                        std::uint32_t binding) const {
  bindings.bind(context, binding, m_numbers);
}

void DeviceSplats::clear(const gpu::Context& context) const { m_numbers.buffer().fillZero(context); }

SplatSums DeviceSplats::download(const gpu::Context& context) const {
  if (!m_wanted)
    return {};
  std::vector<std::uint64_t> numbers(m_numbers.bytes() / sizeof(std::uint64_t));
  m_numbers.buffer().read(context, std::as_writable_bytes(std::span{numbers}));
  return SplatSums(std::move(numbers));
}

} // namespace vkpt
