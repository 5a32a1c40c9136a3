#pragma once
// Pilot runs: which settings of the estimator are worth most in a scene, tried in a small image before the
// render.

#include "device/effects.h"
#include "gpu/context.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace vkpt {

struct PilotPlan {
  EstimatorSettings estimator; ///< to begin with
  /// What is compiled in for these settings.
  std::function<EffectSet(const EstimatorSettings&)> effectsOf;
  std::vector<std::string> fixed; ///< options that stay what they are: "--split"
  double seconds = 0.0;           ///< of rendering, for each setting that is tried
  std::uint32_t seed = 0;
};

struct PilotTrial {
  std::string option; ///< "--path-reuse 64"
  /// 1 / (squared error x seconds) by the films' own standard errors, over that of the settings before.
  double efficiency = 0.0;
  bool kept = false;
};

struct PilotResult {
  std::vector<PilotTrial> trials; ///< as they were done
  int width = 0;                  ///< of the small image
  int height = 0;
  double seconds = 0.0; ///< of all of it, compiling included
};

/// One option after the other, each with what was kept of those before: its values take turns, and one is
/// kept that is worth kPilotGain times the value there was. All of them have the same image as their
/// expectation. A choice follows measured times: it may differ from run to run and from device to device.
/// `observer` hears what is tried, a few times a second, and ends the pilot with what there is by false.
PilotResult runPilot(const gpu::Context& context, const Scene& scene, const PilotPlan& plan,
                     const std::function<bool(const std::string& what)>& observer);

/// Estimates of efficiency scatter by about as much.
inline constexpr double kPilotGain = 1.1;

} // namespace vkpt
