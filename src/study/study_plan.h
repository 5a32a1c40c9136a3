#pragma once
// What a study measures.

#include "device/effects.h"
#include "film/image.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vkpt {

/// One way to render the scene.
struct StudySetting {
  std::string name; ///< as it was asked for: "split=2, light=nee"
  EstimatorSettings estimator;
  PixelFilter filter;
  EffectSet effects; ///< that are compiled in
  std::vector<std::string>
      bias;                 ///< what it lacks by choice, e.g. "--max-bounces 2", where the reference has it
  std::uint32_t batch = 16; ///< frames per dispatch, 1 to kSamplesPerGroup
};

/// Every setting is rendered once for each seed until a limit is met; at least one limit is set.
struct StudyPlan {
  std::vector<StudySetting> settings;
  StudySetting reference;
  std::optional<Image> referenceImage; ///< instead of one that is rendered first
  std::string referenceName;           ///< for people
  /// The settings after the first leave something out of it: energy is judged, not error, so the reference's
  /// noise stops nothing.
  bool ablation = false;
  std::uint32_t seeds = 3;
  std::uint32_t firstSeed = 0;
  std::optional<double> seconds;       ///< of rendering, for a setting and a seed
  std::optional<std::uint64_t> frames; ///< likewise
  std::optional<double> targetError;   ///< relative: a run ends when it is measured to be at most this
};

} // namespace vkpt
