#pragma once
// `vkpt view` on a screen, driven as a user would, and its event log.

#include "view/screen.h"

#include <optional>

namespace vkpt::test {

class Preview {
public:
  /// Starts `vkpt view ARGUMENTS --log-events` under the validation layer.
  Preview(const Screen& screen, const WorkFolder& folder, std::vector<std::string> arguments,
          bool validation = true);

  /// Waits for the next event of this name behind the last one that was waited for. Fails the test, and
  /// returns an empty object, where there is none within a minute.
  nlohmann::json await(const std::string& event);
  /// The events of this name so far.
  [[nodiscard]] std::vector<nlohmann::json> events(const std::string& event) const;
  /// Waits until the window's part of the screen is `expected`, up to 1 in a byte. Returns how many bytes
  /// differ by that, or nothing where some still differ by more after ten seconds.
  [[nodiscard]] std::optional<std::size_t> differences(const Screenshot& expected) const;
  /// Presses keys, as xdotool names them.
  void press(const std::string& keys) const { m_screen.user("key " + keys); }
  /// Presses Esc and waits for the end.
  CommandResult quit();
  CommandResult wait() { return m_command.wait(); }
  [[nodiscard]] std::string output() const { return m_command.output(); }

private:
  const Screen& m_screen;
  RunningCommand m_command;
  std::size_t m_read = 0; ///< characters of stdout
};

/// Pixels of a PNG file.
Screenshot readPng(const fs::path& file);

} // namespace vkpt::test
