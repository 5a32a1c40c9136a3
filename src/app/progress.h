#pragma once
#include "app/status_line.h"
#include "render/render_loop.h"

namespace vkpt {

/// The progress line of a run. Also passes on the user's wish to stop.
class ProgressLine : public RenderObserver {
public:
  explicit ProgressLine(bool visible) : m_line(visible) {}

  void onProgress(const RenderProgress& progress) override;
  bool stopRequested() override;

private:
  StatusLine m_line;
};

} // namespace vkpt
