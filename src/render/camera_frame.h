#pragma once
#include "scene/scene.h"
#include "shared/structs.h"

namespace vkpt {

/// Fills the camera's part of `constants` (eye, image plane at distance 1) for an image of width x height.
/// Throws UsageError when the camera has no direction: eye on target, up along the view, fov outside (0,
/// 180).
void setCamera(shared::FrameConstants& constants, const Scene& scene, int width, int height);

} // namespace vkpt
