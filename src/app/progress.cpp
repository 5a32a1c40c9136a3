#include "app/progress.h"

#include "app/interrupt.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace vkpt {
namespace {

constexpr double kTerminalInterval = 0.25; // seconds between redraws
constexpr double kPlainInterval = 10.0;    // seconds between lines in a log

std::string text(const RenderProgress& p) {
  std::string line = fmt::format("{:.1f} frames, {:.1f} s", p.frames, p.seconds);
  if (p.remainingSeconds)
    line += fmt::format(", {:.1f} s left", *p.remainingSeconds);
  line += fmt::format(", {:.2f} Msamples/s", p.samplesPerSecond * 1e-6);
  if (p.relativeError)
    line += fmt::format(", error {:.2f} %", *p.relativeError * 100.0);
  return line;
}

} // namespace

ProgressLine::ProgressLine(bool visible) : m_visible(visible), m_terminal(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (m_drawn && m_terminal)
    fmt::print(stderr, "\r\033[K");
}

void ProgressLine::onProgress(const RenderProgress& progress) {
  if (!m_visible || m_sinceDrawn.seconds() < (m_terminal ? kTerminalInterval : kPlainInterval))
    return;
  m_sinceDrawn.restart();
  m_drawn = true;
  if (m_terminal) {
    fmt::print(stderr, "\r\033[K{}", text(progress));
    std::fflush(stderr);
  } else {
    fmt::print(stderr, "vkpt: {}\n", text(progress));
  }
}

bool ProgressLine::stopRequested() { return InterruptGuard::requested(); }

} // namespace vkpt
