#include "app/progress.h"

#include "app/interrupt.h"
#include "core/duration.h"

#include <fmt/format.h>

namespace vkpt {
namespace {

std::string text(const RenderProgress& p) {
  std::string line = fmt::format("{:.1f} frames, {:.1f} s", p.frames, p.seconds);
  if (p.remainingSeconds)
    line += fmt::format(", {} left", durationText(*p.remainingSeconds));
  line += fmt::format(", {:.2f} Msamples/s", p.samplesPerSecond * 1e-6);
  if (p.relativeError)
    line += fmt::format(", error {:.2f} %", *p.relativeError * 100.0);
  if (p.relativeError && p.targetError)
    line += fmt::format(" (target {:.3g} %)", *p.targetError * 100.0);
  return line;
}

} // namespace

void ProgressLine::onProgress(const RenderProgress& progress) {
  if (m_line.isDue())
    m_line.draw(text(progress));
}

bool ProgressLine::stopRequested() { return InterruptGuard::requested(); }

} // namespace vkpt
