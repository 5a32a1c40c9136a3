#pragma once
// Puts the film and the panel into the window.

#include "app/view/film_picture.h"
#include "app/view/panel_renderer.h"

#include <functional>

namespace vkpt {

class Presenter {
public:
  Presenter(const gpu::Context& context, Window& window);
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  /// The film is another one, or has moved in memory. All that was drawn must be finished.
  void bind(const Integrator& integrator);
  /// Draws the film of this size and the panel's widgets, which are called in any case. False where the
  /// window had no room: minimised, or busy.
  bool show(Vec2i filmSize, const DisplaySettings& display, Shows shows,
            const std::function<void()>& widgets);
  /// Waits until all that was shown is drawn: before then no film may go.
  void finish() const;

private:
  bool makeRoom();
  void record(const SwapchainFrame& frame, Vec2i filmSize, const DisplaySettings& display, Shows shows) const;

  const gpu::Context& m_context;
  Window& m_window;
  Swapchain m_swapchain;
  FilmPicture m_picture;
  PanelRenderer m_panel;
  vk::raii::CommandPool m_pool;
  vk::raii::CommandBuffers m_commands;
  vk::raii::Fence m_drawn;
};

} // namespace vkpt
