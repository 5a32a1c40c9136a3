#pragma once
// A screen without a monitor, and a user for it: Xvfb and xdotool.

#include "cli/command.h"

#include <array>
#include <string>
#include <vector>

namespace vkpt::test {

/// What stands on a part of the screen: 8-bit R, G, B.
struct Screenshot {
  int width = 0;
  int height = 0;
  std::vector<std::array<int, 3>> pixels;
  [[nodiscard]] const std::array<int, 3>& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
  [[nodiscard]] Screenshot cut(int newWidth, int newHeight) const;
};

/// An X server of its own, ended with this object.
class Screen {
public:
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  [[nodiscard]] const std::string& display() const { return m_display; } ///< ":7"
  [[nodiscard]] Screenshot shoot() const;
  /// Runs xdotool with these words; fails the test where it fails.
  void user(const std::string& words) const;

private:
  WorkFolder m_folder;
  std::string m_display;
  pid_t m_process = -1;
};

} // namespace vkpt::test
