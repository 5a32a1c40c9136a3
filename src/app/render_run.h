#pragma once
// One run from the options to the finished film: what every command that renders a picture does.

#include "app/outputs.h"

namespace vkpt {

/// What a run needs, but for the device.
struct PreparedRun {
  Scene scene;
  RenderJob job;
  EstimatorSettings estimator;
  EffectSet detected; ///< by the scene
  EffectSet effects;  ///< that are compiled in
  SceneReport sceneReport;
  double loadSeconds = 0.0;
};

struct FinishedRun {
  RunReport report;
  Film film;
  KindImages kinds;
};

/// Loads the scene and expands the options, which --verbose tells. Throws SceneError and UsageError.
PreparedRun prepareRun(const RenderOptions& options);

/// What is known of a run before its device is.
RunReport reportOf(const RenderOptions& options, const PreparedRun& prepared);
/// Adds what the film says, and the integrator that made it. The result of the run is there already.
void addFilm(RunReport& report, const Integrator& integrator, const Film& film);

/// Uploads, compiles and renders until a rule stops it.
FinishedRun renderRun(const RenderOptions& options, const PreparedRun& prepared, const gpu::Context& context,
                      RenderObserver& observer);

} // namespace vkpt
