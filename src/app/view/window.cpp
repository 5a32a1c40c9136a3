#include "app/view/window.h"

#include "core/error.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

namespace vkpt {
namespace {

constexpr double kDragThreshold = 3.0; // window coordinates that a click may move

std::string lastError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "no reason given" : text;
}

[[noreturn]] void refuseWithoutDisplay() {
  throw DeviceError(fmt::format("the preview needs a display ({}); vkpt, without view, renders into files "
                                "and needs none",
                                lastError()));
}

/// The largest size of this aspect that fits the main screen's free area.
Vec2i fittedToScreen(Vec2i size) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr)
    return size;
  Vec2i corner(0);
  Vec2i area(0);
  glfwGetMonitorWorkarea(monitor, &corner.x, &corner.y, &area.x, &area.y);
  if (area.x <= 0 || area.y <= 0)
    return size;
  const double scale =
      std::min({1.0, area.x / static_cast<double>(size.x), area.y / static_cast<double>(size.y)});
  return glm::max(Vec2i(1), Vec2i(Vec2d(size) * scale));
}

} // namespace

Window& Window::of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

Window::Window(const std::string& title, int width, int height) {
  if (glfwInit() != GLFW_TRUE)
    refuseWithoutDisplay();
  if (glfwVulkanSupported() != GLFW_TRUE) {
    const std::string reason = lastError();
    glfwTerminate();
    throw DeviceError(fmt::format("no Vulkan for windows ({})", reason));
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  const Vec2i size = fittedToScreen({width, height});
  m_window = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (m_window == nullptr) {
    const std::string reason = lastError();
    glfwTerminate();
    throw DeviceError(fmt::format("no window could be opened ({}); vkpt, without view, needs none", reason));
  }
  glfwSetWindowUserPointer(m_window, this);
  setCallbacks();
}

Window::~Window() {
  glfwDestroyWindow(m_window);
  glfwTerminate();
}

std::vector<std::string> Window::instanceExtensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (names == nullptr)
    throw DeviceError(fmt::format("Vulkan can't present to this window system ({})", lastError()));
  return {names, names + count};
}

VkSurfaceKHR Window::makeSurface(VkInstance instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(instance, m_window, nullptr, &surface) != VK_SUCCESS)
    throw DeviceError(fmt::format("Vulkan can't present to this window ({})", lastError()));
  return surface;
}

Vec2i Window::size() const {
  Vec2i size(0);
  glfwGetWindowSize(m_window, &size.x, &size.y);
  return glfwGetWindowAttrib(m_window, GLFW_ICONIFIED) == GLFW_TRUE ? Vec2i(0) : size;
}

Vec2i Window::surfaceSize() const {
  Vec2i size(0);
  glfwGetFramebufferSize(m_window, &size.x, &size.y);
  return size;
}

float Window::textScale() const {
  float x = 1.0F;
  float y = 1.0F;
  glfwGetWindowContentScale(m_window, &x, &y);
  return std::max({1.0F, x, y});
}

void Window::setTitle(const std::string& title) { glfwSetWindowTitle(m_window, title.c_str()); }

void Window::poll(double wait) {
  if (wait > 0.0)
    glfwWaitEventsTimeout(wait);
  else
    glfwPollEvents();
}

Input Window::takeInput() {
  const auto held = [this](int key) { return glfwGetKey(m_window, key) == GLFW_PRESS; };
  const auto axis = [&held](int plus, int minus) {
    return (held(plus) ? 1.0 : 0.0) - (held(minus) ? 1.0 : 0.0);
  };
  Input input = std::exchange(m_input, {});
  input.quit = input.quit || glfwWindowShouldClose(m_window) == GLFW_TRUE;
  input.flying = m_held == Button::Right;
  if (input.flying) {
    input.fast = held(GLFW_KEY_LEFT_SHIFT);
    input.flight = {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_W, GLFW_KEY_S)};
  }
  return input;
}

void Window::onButton(int button, bool down) {
  const Button which = button == GLFW_MOUSE_BUTTON_LEFT     ? Button::Left
                       : button == GLFW_MOUSE_BUTTON_MIDDLE ? Button::Middle
                       : button == GLFW_MOUSE_BUTTON_RIGHT  ? Button::Right
                                                            : Button::None;
  if (down) {
    if (m_held != Button::None || which == Button::None || ImGui::GetIO().WantCaptureMouse)
      return;
    m_held = which;
    m_pressedAt = m_cursor;
    m_dragged = false;
  } else if (which == m_held) {
    if (!m_dragged && m_held == Button::Left)
      m_input.click = m_cursor;
    if (!m_dragged && m_held == Button::Middle)
      m_input.middleClick = m_cursor;
    m_held = Button::None;
  }
}

void Window::onCursor(Vec2d at) {
  Vec2d way = at - m_cursor;
  m_cursor = at;
  if (m_held == Button::None)
    return;
  if (!m_dragged) {
    way = at - m_pressedAt;
    if (glm::length(way) <= kDragThreshold && m_held != Button::Right)
      return;
    m_dragged = true;
  }
  const bool shift = glfwGetKey(m_window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS;
  if (m_held == Button::Right)
    m_input.look += way;
  else if (m_held == Button::Middle || shift)
    m_input.pan += way;
  else
    m_input.orbit += way;
}

void Window::onKey(int key, int modifiers) {
  m_input.quit = m_input.quit || key == GLFW_KEY_ESCAPE;
  m_input.home = m_input.home || key == GLFW_KEY_HOME;
  m_input.save = m_input.save || (key == GLFW_KEY_S && (modifiers & GLFW_MOD_CONTROL) != 0);
}

void Window::setCallbacks() {
  glfwSetCharCallback(m_window, [](GLFWwindow* w, unsigned character) {
    of(w).m_input.any = true;
    if (!ImGui::GetIO().WantTextInput && of(w).m_held != Button::Right)
      of(w).m_input.typed.push_back(static_cast<char32_t>(character));
  });
  glfwSetKeyCallback(m_window, [](GLFWwindow* w, int key, int, int action, int modifiers) {
    of(w).m_input.any = true;
    if (action == GLFW_PRESS && !ImGui::GetIO().WantTextInput)
      of(w).onKey(key, modifiers);
  });
  glfwSetMouseButtonCallback(m_window, [](GLFWwindow* w, int button, int action, int) {
    of(w).m_input.any = true;
    of(w).onButton(button, action == GLFW_PRESS);
  });
  glfwSetCursorPosCallback(m_window, [](GLFWwindow* w, double x, double y) {
    of(w).m_input.any = true;
    of(w).onCursor({x, y});
  });
  glfwSetScrollCallback(m_window, [](GLFWwindow* w, double, double notches) {
    of(w).m_input.any = true;
    if (!ImGui::GetIO().WantCaptureMouse)
      of(w).m_input.dolly += notches;
  });
  glfwSetWindowRefreshCallback(m_window, [](GLFWwindow* w) { of(w).m_input.any = true; });
  glfwSetWindowSizeCallback(m_window, [](GLFWwindow* w, int, int) { of(w).m_input.any = true; });
}

} // namespace vkpt
