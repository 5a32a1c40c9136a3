#pragma once
// Whether paths from the lights go with the eye's: shaders/lib/light_path.glsl.

#include "device/effects.h"

namespace vkpt {

/// What keeps them from being traced: an option they can't go together with, or a scene that has no use for
/// them.
struct LightTracingObstacle {
  EffectReason reason;
  bool impossible = false; ///< even if asked for
};
/// Nothing where they are traced.
std::optional<LightTracingObstacle> lightTracingObstacle(const Scene& scene,
                                                         const EstimatorSettings& settings);

/// Whether directions are guided by what paths from the lights have shown: shaders/lib/guide.glsl. What is
/// against it, or nothing.
std::optional<EffectReason> guidingObstacle(const Scene& scene, const EstimatorSettings& settings);

/// At most so many boxes that hold the specular triangles: those of a material in one, unless there are too
/// many.
std::vector<Box3d> specularBoxes(const Scene& scene, std::size_t most);

} // namespace vkpt
