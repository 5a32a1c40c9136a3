#pragma once
// What each effect costs on a device, measured.

#include "device/effects.h"
#include "device/estimator_settings.h"
#include "device/packed_scene.h"

#include <functional>
#include <optional>
#include <vector>

namespace vkpt::gpu {
class Context;
}

namespace vkpt {

/// The time of a closest-hit ray, shading and shadow rays included, with the effect over that without it: the
/// median over turns in which both run one after the other. An effect that is off is compiled in though
/// nothing calls for it, on the same paths; one that is on is left out, which changes the paths, so that ray
/// is compared with ray.
struct EffectCost {
  Effect effect = Effect::Diffuse;
  double nanosecondsWith = 0.0; ///< medians
  double nanosecondsWithout = 0.0;
  double ratio = 1.0;  ///< median over the turns
  double spread = 0.0; ///< half the distance of the ratios' quartiles
  bool samePaths = false;
};

struct CostSettings {
  int edge = 64; ///< pixels of the square image
  int turns = 7;
  double seconds = 0.05; ///< of one render
};

/// Of every effect for which it can be told: without roulette or a limit on bounces paths may not end. Calls
/// `onMeasured` after each. `packed`: the scene with all buffers; what a variant does not read costs it
/// nothing.
std::vector<EffectCost> measureEffectCosts(const gpu::Context& context, const Scene& scene,
                                           const PackedScene& packed, const EstimatorSettings& estimator,
                                           const EffectSet& effects, const CostSettings& settings,
                                           const std::function<void(const EffectCost&)>& onMeasured);

} // namespace vkpt
