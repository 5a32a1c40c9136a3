#pragma once
// Where light comes from by way of specular surfaces, before a render.

#include "device/effects.h"
#include "device/packed_scene.h"

namespace vkpt {

/// Traces paths from the lights and makes the scene's guide of what they bring, where the effects have guided
/// directions. Neither the camera nor a seed matter to it. threads: 0: as many as the machine has; the result
/// does not depend on them.
void learnGuide(PackedScene& scene, const Scene& source, const EffectSet& effects,
                const EstimatorSettings& estimator, unsigned threads = 0);

/// Which lights matter where: the scene's grid of lights (device/light_grid.h), by the host's float program.
/// threads: as above.
void learnLights(PackedScene& scene, const Scene& source, const EffectSet& effects,
                 const EstimatorSettings& estimator, unsigned threads = 0);

/// Both.
void learnScene(PackedScene& scene, const Scene& source, const EffectSet& effects,
                const EstimatorSettings& estimator, unsigned threads = 0);

/// packScene(), and what is learned.
PackedScene packGuided(const Scene& scene, const EstimatorSettings& estimator, const EffectSet& effects,
                       unsigned threads = 0);

} // namespace vkpt
