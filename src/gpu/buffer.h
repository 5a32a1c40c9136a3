#pragma once
// Device buffers and texel views.

#include "gpu/context.h"

#include <span>

namespace vkpt::gpu {

enum class MemoryKind {
  Device, ///< the device's own; written through a staging buffer unless the host can see it
  Host,   ///< seen by the host, coherent: counters, constants, staging
};

/// A buffer with memory of its own. Sizes are bytes and at least 16: Vulkan has no empty buffers.
class Buffer {
public:
  Buffer() = default;
  /// Throws DeviceError naming `what`, the need and the limit.
  Buffer(const Context& context, std::string what, vk::DeviceSize bytes, vk::BufferUsageFlags usage,
         MemoryKind kind);

  [[nodiscard]] vk::Buffer handle() const { return *m_buffer; }
  [[nodiscard]] vk::DeviceSize bytes() const { return m_bytes; }
  /// Host address; null when the host can't see the memory.
  [[nodiscard]] void* mapped() const { return m_mapped; }

  void write(const Context& context, std::span<const std::byte> data) const;
  /// From byte `offset` on, a multiple of 4.
  void read(const Context& context, std::span<std::byte> data, vk::DeviceSize offset = 0) const;
  /// The first `bytes`, a multiple of 4.
  void fillZero(const Context& context, vk::DeviceSize bytes = VK_WHOLE_SIZE) const;

private:
  std::string m_what;
  vk::DeviceSize m_bytes = 0;
  vk::raii::DeviceMemory m_memory = nullptr;
  vk::raii::Buffer m_buffer = nullptr;
  void* m_mapped = nullptr;
};

/// An array of rgba32ui texels, or of single numbers (eR32Uint); at least one texel.
class TexelBuffer {
public:
  TexelBuffer() = default;
  /// What it holds is not defined.
  TexelBuffer(const Context& context, const std::string& what, vk::DeviceSize texels,
              vk::Format format = vk::Format::eR32G32B32A32Uint);
  TexelBuffer(const Context& context, const std::string& what, std::span<const std::byte> data);
  [[nodiscard]] const Buffer& buffer() const { return m_buffer; }
  [[nodiscard]] vk::BufferView view() const { return *m_view; }
  [[nodiscard]] vk::DeviceSize bytes() const { return m_buffer.bytes(); }

private:
  Buffer m_buffer;
  vk::raii::BufferView m_view = nullptr;
};

/// Of several buffers together.
template<class Buffers>
[[nodiscard]] vk::DeviceSize bytesOf(const Buffers& buffers) {
  vk::DeviceSize sum = 0;
  for (const auto& buffer : buffers)
    sum += buffer.bytes();
  return sum;
}

} // namespace vkpt::gpu
