#include "gpu/buffer.h"

#include "core/error.h"
#include "gpu/huge_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

namespace vkpt::gpu {
namespace {

constexpr vk::DeviceSize kSmallestBuffer = 16;
constexpr vk::DeviceSize kTexelBytes = 16;

std::optional<std::uint32_t> findMemoryType(const Context& context, std::uint32_t allowed,
                                            vk::MemoryPropertyFlags wanted) {
  for (std::uint32_t i = 0; i < context.memory().memoryTypeCount; ++i) {
    const bool has = (context.memory().memoryTypes[i].propertyFlags & wanted) == wanted;
    if (((allowed >> i) & 1U) != 0U && has)
      return i;
  }
  return std::nullopt;
}

std::uint32_t chooseMemoryType(const Context& context, std::uint32_t allowed, MemoryKind kind) {
  using Flag = vk::MemoryPropertyFlagBits;
  const auto hostVisible = Flag::eHostVisible | Flag::eHostCoherent;
  const auto first = kind == MemoryKind::Device ? vk::MemoryPropertyFlags(Flag::eDeviceLocal) : hostVisible;
  auto type = findMemoryType(context, allowed, first);
  if (!type)
    type = findMemoryType(context, allowed, {});
  if (!type)
    throw DeviceError("the Vulkan device has no memory for buffers");
  return *type;
}

} // namespace

Buffer::Buffer(const Context& context, std::string what, vk::DeviceSize bytes, vk::BufferUsageFlags usage,
               MemoryKind kind)
    : m_what(std::move(what)), m_bytes(std::max(bytes, kSmallestBuffer)) {
  using Flag = vk::MemoryPropertyFlagBits;
  usage |= vk::BufferUsageFlagBits::eTransferDst | vk::BufferUsageFlagBits::eTransferSrc;
  try {
    m_buffer = vk::raii::Buffer(context.device(), {{}, m_bytes, usage, vk::SharingMode::eExclusive});
    const auto needs = m_buffer.getMemoryRequirements();
    const std::uint32_t type = chooseMemoryType(context, needs.memoryTypeBits, kind);
    m_memory = vk::raii::DeviceMemory(context.device(), {needs.size, type});
    m_buffer.bindMemory(*m_memory, 0);
    const auto flags = context.memory().memoryTypes[type].propertyFlags;
    if ((flags & Flag::eHostVisible) && (flags & Flag::eHostCoherent)) {
      m_mapped = m_memory.mapMemory(0, VK_WHOLE_SIZE);
      adviseHugePages(m_mapped, m_bytes);
    }
  } catch (const vk::SystemError& e) {
    throw DeviceError(fmt::format("{}: no room for {} ({:.1f} MB): {}", context.info().name, m_what,
                                  static_cast<double>(m_bytes) * 1e-6, e.what()));
  }
}

void Buffer::write(const Context& context, std::span<const std::byte> data) const {
  if (data.empty())
    return;
  if (m_mapped != nullptr) {
    std::memcpy(m_mapped, data.data(), data.size());
    return;
  }
  const Buffer staging(context, "staging for " + m_what, data.size(), {}, MemoryKind::Host);
  std::memcpy(staging.mapped(), data.data(), data.size());
  context.execute([&](const vk::raii::CommandBuffer& commands) {
    commands.copyBuffer(staging.handle(), handle(), vk::BufferCopy(0, 0, data.size()));
  });
}

void Buffer::read(const Context& context, std::span<std::byte> data, vk::DeviceSize offset) const {
  if (data.empty())
    return;
  if (m_mapped != nullptr) {
    std::memcpy(data.data(), static_cast<const std::byte*>(m_mapped) + offset, data.size());
    return;
  }
  const Buffer staging(context, "staging for " + m_what, data.size(), {}, MemoryKind::Host);
  context.execute([&](const vk::raii::CommandBuffer& commands) {
    commands.copyBuffer(handle(), staging.handle(), vk::BufferCopy(offset, 0, data.size()));
    const vk::MemoryBarrier toHost(vk::AccessFlagBits::eTransferWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eHost, {},
                             toHost, {}, {});
  });
  std::memcpy(data.data(), staging.mapped(), data.size());
}

void Buffer::fillZero(const Context& context, vk::DeviceSize bytes) const {
  context.execute(
      [&](const vk::raii::CommandBuffer& commands) { commands.fillBuffer(handle(), 0, bytes, 0); });
}

TexelBuffer::TexelBuffer(const Context& context, const std::string& what, vk::DeviceSize texels,
                         vk::Format format) {
  if (texels > context.limits().maxTexelBufferElements) {
    throw DeviceError(fmt::format("{}: {} need {} texels; the device's limit is {}", context.info().name,
                                  what, texels, context.limits().maxTexelBufferElements));
  }
  const vk::DeviceSize texelBytes = format == vk::Format::eR32Uint ? 4 : kTexelBytes;
  m_buffer = Buffer(context, what, texels * texelBytes, vk::BufferUsageFlagBits::eStorageTexelBuffer,
                    MemoryKind::Device);
  m_view = vk::raii::BufferView(context.device(), {{}, m_buffer.handle(), format, 0, m_buffer.bytes()});
}

TexelBuffer::TexelBuffer(const Context& context, const std::string& what, std::span<const std::byte> data)
    : TexelBuffer(context, what, data.size() / kTexelBytes) {
  m_buffer.write(context, data);
}

} // namespace vkpt::gpu
