#pragma once
// Renders what a study asks for, and measures it.

#include "gpu/context.h"
#include "scene/scene.h"
#include "study/study_result.h"

#include <functional>

namespace vkpt {

struct StudyProgress {
  double share = 0.0;       ///< of the whole study, by planned work
  double secondsLeft = 0.0; ///< of it
  std::string what;         ///< is under way
};

/// Is called a few times a second; false ends the study with what there is.
using StudyObserver = std::function<bool(const StudyProgress&)>;

/// A reference takes this many times the work of a run, so that its variance is below kMostReferenceNoise of
/// a run's where both are rendered alike.
inline constexpr double kReferenceWork = 10.0;

/// The reference first, then each seed: within a seed the settings take turns, the one that has rendered the
/// shortest time next, so that a machine whose speed drifts hits them alike. The clock of a run holds its
/// dispatches alone. When one of the runs comes so near to the reference that its noise would decide, all
/// stop there, in this seed and the next ones. Throws UsageError for a reference of another size.
StudyResult runStudy(const gpu::Context& context, const Scene& scene, const StudyPlan& plan,
                     const StudyObserver& observer);

} // namespace vkpt
