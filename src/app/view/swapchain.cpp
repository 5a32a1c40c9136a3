#include "app/view/swapchain.h"

#include "core/error.h"

#include <algorithm>
#include <array>

namespace vkpt {
namespace {

/// The colours come encoded, so the format must not encode them again.
vk::SurfaceFormatKHR chooseFormat(const std::vector<vk::SurfaceFormatKHR>& formats) {
  for (const vk::Format wanted : {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm}) {
    const auto found = std::ranges::find_if(formats, [&](const vk::SurfaceFormatKHR& f) {
      return f.format == wanted && f.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear;
    });
    if (found != formats.end())
      return *found;
  }
  throw DeviceError("the window takes no 8-bit colours; choose another device with --device");
}

/// A mode that never waits for the screen where there is one: the render loop has better things to do.
vk::PresentModeKHR chooseMode(const std::vector<vk::PresentModeKHR>& modes) {
  for (const auto wanted : {vk::PresentModeKHR::eMailbox, vk::PresentModeKHR::eImmediate}) {
    if (std::ranges::find(modes, wanted) != modes.end())
      return wanted;
  }
  return vk::PresentModeKHR::eFifo; // always there
}

vk::CompositeAlphaFlagBitsKHR chooseAlpha(const vk::SurfaceCapabilitiesKHR& can) {
  using Alpha = vk::CompositeAlphaFlagBitsKHR;
  for (const Alpha wanted : {Alpha::eOpaque, Alpha::eInherit, Alpha::ePreMultiplied}) {
    if (can.supportedCompositeAlpha & wanted)
      return wanted;
  }
  return Alpha::ePostMultiplied;
}

vk::Extent2D chooseExtent(const vk::SurfaceCapabilitiesKHR& can, Vec2i size) {
  constexpr std::uint32_t kOurs = 0xFFFFFFFF; // the surface takes the size of the images
  if (can.currentExtent.width != kOurs)
    return can.currentExtent;
  return {
      std::clamp(static_cast<std::uint32_t>(size.x), can.minImageExtent.width, can.maxImageExtent.width),
      std::clamp(static_cast<std::uint32_t>(size.y), can.minImageExtent.height, can.maxImageExtent.height)};
}

} // namespace

Swapchain::Swapchain(const gpu::Context& context)
    : m_context(context),
      m_format(chooseFormat(context.physicalDevice().getSurfaceFormatsKHR(context.surface()))),
      m_mode(chooseMode(context.physicalDevice().getSurfacePresentModesKHR(context.surface()))) {
  const auto can = context.physicalDevice().getSurfaceCapabilitiesKHR(context.surface());
  if (!(can.supportedUsageFlags & vk::ImageUsageFlagBits::eTransferDst))
    throw DeviceError("the window's images can't be copied into; choose another device with --device");
}

bool Swapchain::isBgr() const { return m_format.format == vk::Format::eB8G8R8A8Unorm; }

void Swapchain::resize(Vec2i size) {
  const auto can = m_context.physicalDevice().getSurfaceCapabilitiesKHR(m_context.surface());
  const vk::Extent2D extent = chooseExtent(can, size);
  if (extent.width == 0 || extent.height == 0)
    return; // minimised meanwhile; still stale
  constexpr std::uint32_t kImages = 3;
  std::uint32_t images = std::max(kImages, can.minImageCount);
  if (can.maxImageCount > 0)
    images = std::min(images, can.maxImageCount);
  const vk::SwapchainCreateInfoKHR info(
      {}, m_context.surface(), images, m_format.format, m_format.colorSpace, extent, 1,
      vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferDst,
      vk::SharingMode::eExclusive, {}, can.currentTransform, chooseAlpha(can), m_mode, VK_TRUE, *m_swapchain);
  m_views.clear();
  m_swapchain = vk::raii::SwapchainKHR(m_context.device(), info);
  m_images.clear();
  for (const VkImage image : m_swapchain.getImages()) {
    m_images.emplace_back(image);
    m_views.emplace_back(m_context.device(),
                         vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D, m_format.format, {},
                                                 {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}));
  }
  m_acquired.clear();
  m_drawn.clear();
  for (std::size_t i = 0; i <= m_images.size(); ++i)
    m_acquired.emplace_back(m_context.device(), vk::SemaphoreCreateInfo{});
  for (std::size_t i = 0; i < m_images.size(); ++i)
    m_drawn.emplace_back(m_context.device(), vk::SemaphoreCreateInfo{});
  m_size = {static_cast<int>(extent.width), static_cast<int>(extent.height)};
  m_stale = false;
}

std::optional<SwapchainFrame> Swapchain::acquire() {
  constexpr std::uint64_t kPatience = 5'000'000; // ns; then another unit of work comes first
  if (m_stale)
    return std::nullopt;
  const vk::Semaphore acquired = *m_acquired[m_turn];
  std::uint32_t index = 0;
  // The C call: being out of date is no exception here.
  const auto result = static_cast<vk::Result>(m_context.device().getDispatcher()->vkAcquireNextImageKHR(
      *m_context.device(), *m_swapchain, kPatience, acquired, VK_NULL_HANDLE, &index));
  switch (result) {
  case vk::Result::eSuboptimalKHR: // good for this once
    break;
  case vk::Result::eSuccess:
    break;
  case vk::Result::eTimeout:
  case vk::Result::eNotReady:
    return std::nullopt;
  case vk::Result::eErrorOutOfDateKHR:
    m_stale = true;
    return std::nullopt;
  default:
    throw DeviceError("the window gives no image: " + vk::to_string(result));
  }
  m_turn = (m_turn + 1) % m_acquired.size();
  return SwapchainFrame{index, m_images[index], *m_views[index], acquired, *m_drawn[index]};
}

void Swapchain::present(const SwapchainFrame& frame) {
  const vk::PresentInfoKHR info(frame.drawn, *m_swapchain, frame.index);
  const VkPresentInfoKHR& plain = info;
  const auto result = static_cast<vk::Result>(
      m_context.device().getDispatcher()->vkQueuePresentKHR(*m_context.queue(), &plain));
  if (result == vk::Result::eErrorOutOfDateKHR || result == vk::Result::eSuboptimalKHR)
    m_stale = true;
  else if (result != vk::Result::eSuccess)
    throw DeviceError("the window shows no image: " + vk::to_string(result));
}

} // namespace vkpt
