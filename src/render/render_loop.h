#pragma once
// The render loop: the one place where iterations are dispatched until a rule stops them.

#include "film/power_law.h"
#include "render/render_job.h"

#include <vector>

namespace vkpt {

struct RenderProgress {
  double frames = 0.0;                    ///< finished, as an average over the pixels
  double seconds = 0.0;                   ///< of rendering so far
  std::optional<double> remainingSeconds; ///< by the rule that will stop the run first, where that is known
  double samplesPerSecond = 0.0;
  std::optional<double> relativeError; ///< 95 % upper bound, as of the last look at the film
  std::optional<double> targetError;   ///< that ends the run
};

/// Watches a run. The loop calls it after every unit of work; it may not touch the integrator.
class RenderObserver {
public:
  virtual ~RenderObserver() = default;
  virtual void onProgress(const RenderProgress&) {}
  /// A unit of work is under way, between two dispatches; the film is as it was before the unit.
  virtual void onDispatch() {}
  /// The film was read back, which is done now and then.
  virtual void onLook(Film&&, const FilmStatistics&) {}
  /// True ends the run after the unit of work that is under way.
  virtual bool stopRequested() { return false; }
  /// The run is about to end for this reason. An observer may wait here, even change the job, and return
  /// true: then the run goes on where it stopped. Its time here is no time of rendering.
  virtual bool goesOn(StopReason) { return false; }
};

struct RenderResult {
  StopReason stop = StopReason::Frames;
  double seconds = 0.0;
  double frames = 0.0; ///< samples per pixel; a whole number unless a batch was left unfinished
  /// The film's relative error after so many frames, looked at now and then; the last one at the end.
  std::vector<ErrorAtWork> looks;
};

/// Renders until a rule of `job` is met, whichever is first. `job` may change while the observer has the
/// word.
RenderResult renderUntil(Integrator& integrator, const RenderJob& job, RenderObserver& observer);

/// The same; then leaves the film in `film`, and looks at its error.
RenderResult renderUntil(Integrator& integrator, Film& film, const RenderJob& job, RenderObserver& observer);

} // namespace vkpt
