#pragma once
// What stays the same over a render, as the kernels and the host programs read it.

#include "device/estimator_settings.h"
#include "device/packed_scene.h"
#include "scene/scene.h"
#include "shared/structs.h"

namespace vkpt {

/// Fills the camera's part of `constants` (eye, image plane at distance 1) for an image of width x height.
/// Throws UsageError when the camera has no direction: eye on target, up along the view, fov outside (0,
/// 180).
void setCamera(shared::FrameConstants& constants, const Scene& scene, int width, int height);

/// All of the constants; throws as setCamera() does.
shared::FrameConstants frameConstants(const Scene& scene, const LightChoice& lights,
                                      const EstimatorSettings& estimator, int width, int height,
                                      std::uint32_t seed);

} // namespace vkpt
