#pragma once
#include "app/options.h"

namespace vkpt {

/// The options' scene with all that they say about it: size, camera, background, environment, filter.
/// Warnings go to the log; with --strict the first one is thrown. Throws SceneError and UsageError.
Scene loadSceneFor(const RenderOptions& options, SceneReport& report);

/// Puts a warning into the log and the report; with --strict throws SceneError.
void warn(const RenderOptions& options, const std::string& warning, SceneReport& report);

/// What is compiled in for the scene, by --effects; warns of an effect that is left out and was not on.
EffectSet effectsFor(const RenderOptions& options, const EffectSet& detected, SceneReport& report);

/// Says that triangles were left out as they are nothing (isNothing()), if there were any.
void noteLeftOut(std::size_t triangles, SceneReport& report);

} // namespace vkpt
