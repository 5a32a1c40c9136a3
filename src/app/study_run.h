#pragma once
// From the options of a study to what it measured: what vkpt study and vkpt assignment share.

#include "app/study_options.h"
#include "study/run_study.h"
#include "study/study_report.h"

namespace vkpt {

/// A scene that is to be studied.
struct LoadedStudy {
  Scene scene;
  StudyPlan plan;
  std::string folder; ///< of its files, where there are several scenes
  double loadSeconds = 0.0;
};

/// Every scene of the study, with the reference where a file gives it. Throws SceneError and UsageError.
std::vector<LoadedStudy> loadStudies(const StudyOptions& options);

StudySection runLoaded(const StudyOptions& options, const LoadedStudy& loaded, const gpu::Context& context,
                       const StudyObserver& observer);

/// Interrupted, or faults were counted, or done.
ExitCode exitCodeOf(const StudyResult& result);

} // namespace vkpt
