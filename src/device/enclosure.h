#pragma once
// Whether anything outside the scene can be seen at all.

#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace vkpt {

/// A material of a closed mesh of opaque triangles about the camera: no path from it ever leaves the scene.
/// Empty where that is not proven, as when walls meet without sharing their corners.
std::optional<std::uint32_t> enclosingMaterial(const Scene& scene);

} // namespace vkpt
