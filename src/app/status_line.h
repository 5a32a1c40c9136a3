#pragma once
#include "core/clock.h"

#include <string>

namespace vkpt {

/// A line on stderr that tells how far a command is: redrawn a few times a second on a terminal, a plain line
/// now and then elsewhere.
class StatusLine {
public:
  explicit StatusLine(bool visible);
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Time to draw it again.
  [[nodiscard]] bool isDue() const;
  void draw(const std::string& text);
  /// For what goes to stdout: takes the line off a terminal.
  void clear();
  [[nodiscard]] bool onTerminal() const { return m_visible && m_terminal; }

private:
  bool m_visible;
  bool m_terminal;
  bool m_drawn = false;
  Stopwatch m_sinceDrawn;
};

} // namespace vkpt
