#pragma once
// The panel: what the render is like, and what can be changed.

#include "app/view/pixel_report.h"
#include "render/render_loop.h"

namespace vkpt {

inline constexpr float kPanelWidth = 21.0F; ///< in heights of a letter

/// One look at the film's error.
struct ErrorLook {
  double seconds = 0.0;
  double frames = 0.0;
  double relative = 0.0; ///< estimated sqrt(relMSE)
};

/// What it tells.
struct PanelFacts {
  RenderProgress progress;
  Vec2i filmSize{0};
  int coarseness = 1; ///< pixels of the window that one of the film's is wide
  std::vector<ErrorLook> looks;
  std::optional<StopReason> rests; ///< why nothing is rendered just now
  RunCounters counters;
  std::vector<std::string> effects;
  std::vector<std::string> bias;
  std::string device;
  std::string scene;
  std::optional<PixelReport> pixel;
  std::string message; ///< of the moment; empty: none
};

/// What was asked for by its buttons.
struct PanelRequests {
  bool save = false;
  bool printCamera = false;
  bool frameScene = false;
  bool homeCamera = false;
};

/// Calls the widgets; changes `settings` as the user does.
PanelRequests drawPanel(const PanelFacts& facts, ViewSettings& settings);

} // namespace vkpt
