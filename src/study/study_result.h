#pragma once
// What a study has measured.

#include "film/film.h"
#include "study/reference.h"
#include "study/study_plan.h"

namespace vkpt {

struct StudyPoint {
  std::uint64_t frames = 0;
  double seconds = 0.0;   ///< of rendering alone
  SquaredError error;     ///< without the reference's noise, which is subtracted; may be below 0 by chance
  double predicted = 0.0; ///< relMSE that the run's own variances tell; 0: not known
};

/// One setting with one seed.
struct StudyRun {
  std::uint32_t seed = 0;
  std::vector<StudyPoint> points; ///< by frames; the last one at the end
  Vec3d mean{0.0};                ///< of the image, at the end
  Vec3d standardError{0.0};       ///< of that mean
};

struct SettingResult {
  StudySetting setting;
  std::vector<StudyRun> runs;  ///< one for each seed that was finished, or broken off
  double compileSeconds = 0.0; ///< building and compiling, not in the clock
  Image picture;               ///< at the end of the first seed
  std::uint64_t faults = 0;
};

enum class StudyStop {
  Limits,         ///< time or frames
  ReferenceNoise, ///< the reference's own noise would have decided
  User,
};

struct StudyResult {
  std::vector<SettingResult> settings;
  bool ablation = false; ///< see StudyPlan
  Vec3d referenceMean{0.0};
  Vec3d referenceMeanError{0.0};
  SquaredError referenceNoise;
  bool referenceNoiseIsKnown = true;
  Image referenceImage;
  double referenceFrames = 0.0;  ///< 0 for a file
  double referenceSeconds = 0.0; ///< likewise
  double measuringSeconds = 0.0; ///< reading films back and comparing, not in the clock
  double overheadSeconds = 0.0;  ///< all that is neither rendering nor compiling: measuring, taking turns
  double renderSeconds = 0.0;    ///< the clocks of all runs
  StudyStop stop = StudyStop::Limits;
  std::optional<double> targetError; ///< see StudyPlan
  double equalSeconds = 0.0;         ///< that every run reached
  std::uint64_t equalFrames = 0;     ///< the most that every run has a point at
};

} // namespace vkpt
