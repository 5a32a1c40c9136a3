#include "app/status_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace vkpt {
namespace {

constexpr double kTerminalInterval = 0.25; // seconds between redraws
constexpr double kPlainInterval = 10.0;    // seconds between lines in a log

} // namespace

StatusLine::StatusLine(bool visible) : m_visible(visible), m_terminal(isatty(STDERR_FILENO) == 1) {}

StatusLine::~StatusLine() { clear(); }

void StatusLine::clear() {
  if (m_drawn && m_terminal)
    fmt::print(stderr, "\r\033[K");
}

bool StatusLine::isDue() const {
  return m_visible && m_sinceDrawn.seconds() >= (m_terminal ? kTerminalInterval : kPlainInterval);
}

void StatusLine::draw(const std::string& text) {
  m_sinceDrawn.restart();
  m_drawn = true;
  if (m_terminal) {
    fmt::print(stderr, "\r\033[K{}", text);
    std::fflush(stderr);
  } else {
    fmt::print(stderr, "vkpt: {}\n", text);
  }
}

} // namespace vkpt
