#pragma once
// Dear ImGui on Vulkan: the panel, drawn over the picture.

#include "app/view/swapchain.h"
#include "app/view/window.h"

namespace vkpt {

class PanelRenderer {
public:
  PanelRenderer(const gpu::Context& context, const Window& window, const Swapchain& swapchain);
  ~PanelRenderer();
  PanelRenderer(const PanelRenderer&) = delete;
  PanelRenderer& operator=(const PanelRenderer&) = delete;

  /// After the swapchain was resized. The device must be idle.
  void resize(const Swapchain& swapchain);
  /// Between the two the panel's widgets are called.
  void begin();
  void end();
  /// Records the drawing into an image that is a transfer's destination; afterwards it can be presented.
  void draw(const vk::raii::CommandBuffer& commands, const SwapchainFrame& frame) const;

private:
  void makeFont();
  void setStyle();

  const gpu::Context& m_context;
  const Window& m_window;
  vk::raii::DescriptorPool m_pool = nullptr;
  vk::raii::RenderPass m_pass = nullptr;
  std::vector<vk::raii::Framebuffer> m_framebuffers;
  Vec2i m_size{0};
  float m_scale = 1.0F; ///< that the font was made for
};

} // namespace vkpt
