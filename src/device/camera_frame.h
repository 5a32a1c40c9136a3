#pragma once
// What stays the same over a render, as the kernels and the host programs read it.

#include "device/device_scene.h"
#include "device/estimator_settings.h"
#include "scene/scene.h"
#include "shared/structs.h"

namespace vkpt {

/// Fills the part of `constants` that says which image is seen: the camera (eye, image plane at distance 1),
/// and the size with its blocks. Throws UsageError when the camera has no direction: eye on target, up along
/// the view, fov outside (0, 180).
void setView(shared::FrameConstants& constants, const Scene& scene, int width, int height);

/// All of the constants; throws as setView() does.
shared::FrameConstants frameConstants(const Scene& scene, const LightChoice& lights,
                                      const EstimatorSettings& estimator, int width, int height,
                                      std::uint32_t seed);

} // namespace vkpt
