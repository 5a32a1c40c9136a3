#pragma once
// The window: GLFW, and what the user did in it. Nothing else knows of GLFW but the panel's back end.

#include "core/math.h"

#include <vulkan/vulkan.h>

#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace vkpt {

/// What the user did since it was last asked. Ways are in window coordinates, y downwards.
struct Input {
  std::u32string typed;
  bool save = false; ///< Ctrl+S
  bool quit = false; ///< Esc, or the window is to be closed
  bool home = false;
  Vec2d orbit{0.0}; ///< way of the mouse, by what it did
  Vec2d pan{0.0};
  Vec2d look{0.0};
  double dolly = 0.0; ///< notches of the wheel, forwards above 0
  bool flying = false;
  bool fast = false;                ///< Shift
  Vec3d flight{0.0};                ///< right, up, forwards: -1, 0 or 1 each
  std::optional<Vec2d> click;       ///< left button without a drag
  std::optional<Vec2d> middleClick; ///< the same for the middle one
  bool any = false;                 ///< anything at all, the panel's share included
};

class Window {
public:
  /// Throws DeviceError: one line that names the headless way, where there is no display. The window may come
  /// out smaller where the screen is.
  Window(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  [[nodiscard]] GLFWwindow* handle() const { return m_window; }
  /// Extensions of a Vulkan instance that the window system needs.
  [[nodiscard]] std::vector<std::string> instanceExtensions() const;
  /// Throws DeviceError.
  [[nodiscard]] VkSurfaceKHR makeSurface(VkInstance instance) const;

  /// Of the picture, in window coordinates; 0 while minimised.
  [[nodiscard]] Vec2i size() const;
  /// Of the surface, in its pixels: more than size() on some screens of high density.
  [[nodiscard]] Vec2i surfaceSize() const;
  /// How much larger text is to be than on a screen of ordinary density.
  [[nodiscard]] float textScale() const;
  void setTitle(const std::string& title);

  /// Lets the window system speak; `wait` is the longest time to wait for it to have something to say, in s.
  void poll(double wait = 0.0);
  [[nodiscard]] Input takeInput();

private:
  enum class Button { None, Left, Middle, Right };
  static Window& of(GLFWwindow* window);
  void setCallbacks();
  void onButton(int button, bool down);
  void onCursor(Vec2d at);
  void onKey(int key, int modifiers);

  GLFWwindow* m_window = nullptr;
  Input m_input;
  Button m_held = Button::None;
  Vec2d m_pressedAt{0.0};
  Vec2d m_cursor{0.0};
  bool m_dragged = false;
};

} // namespace vkpt
