#pragma once
#include "core/clock.h"
#include "render/render_loop.h"

namespace vkpt {

/// The progress line on stderr: redrawn a few times a second on a terminal, a plain line now and then
/// elsewhere. Also passes on the user's wish to stop.
class ProgressLine : public RenderObserver {
public:
  explicit ProgressLine(bool visible);
  ~ProgressLine() override;
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void onProgress(const RenderProgress& progress) override;
  bool stopRequested() override;

private:
  bool m_visible;
  bool m_terminal;
  bool m_drawn = false;
  Stopwatch m_sinceDrawn;
};

} // namespace vkpt
