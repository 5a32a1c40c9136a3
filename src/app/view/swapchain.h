#pragma once
// The images of the window, in turn: made anew whenever the window has become another one.

#include "core/math.h"
#include "gpu/context.h"

#include <optional>
#include <vector>

namespace vkpt {

/// An image to draw into, and what to wait for and to signal around the drawing.
struct SwapchainFrame {
  std::uint32_t index = 0;
  vk::Image image;
  vk::ImageView view;
  vk::Semaphore acquired;
  vk::Semaphore drawn;
};

class Swapchain {
public:
  /// Of the context's surface; throws DeviceError where it takes no 8-bit colours that can be copied into.
  explicit Swapchain(const gpu::Context& context);

  /// For a surface of this size, which may not be 0. The device must be idle.
  void resize(Vec2i size);
  [[nodiscard]] Vec2i size() const { return m_size; }
  [[nodiscard]] vk::Format format() const { return m_format.format; }
  /// Bytes in the order B G R A, not R G B A.
  [[nodiscard]] bool isBgr() const;
  [[nodiscard]] std::uint32_t imageCount() const { return static_cast<std::uint32_t>(m_images.size()); }
  [[nodiscard]] const std::vector<vk::raii::ImageView>& views() const { return m_views; }

  /// Nothing where none is free just now, or where the window has become another one: see isStale().
  [[nodiscard]] std::optional<SwapchainFrame> acquire();
  void present(const SwapchainFrame& frame);
  /// To be resized before it is of use again.
  [[nodiscard]] bool isStale() const { return m_stale; }

private:
  const gpu::Context& m_context;
  vk::SurfaceFormatKHR m_format;
  vk::PresentModeKHR m_mode = vk::PresentModeKHR::eFifo;
  vk::raii::SwapchainKHR m_swapchain = nullptr;
  std::vector<vk::Image> m_images;
  std::vector<vk::raii::ImageView> m_views;
  std::vector<vk::raii::Semaphore> m_acquired; ///< in turn; one more than may be in use
  std::vector<vk::raii::Semaphore> m_drawn;    ///< one for each image
  std::size_t m_turn = 0;
  Vec2i m_size{0};
  bool m_stale = true;
};

} // namespace vkpt
