#pragma once

#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace vkpt {

/// The scene's image, so many times as wide and as high, rounded; at least a pixel.
inline void scaleImage(Scene& scene, double factor) {
  scene.width = std::max(1, static_cast<int>(std::lround(scene.width * factor)));
  scene.height = std::max(1, static_cast<int>(std::lround(scene.height * factor)));
}

} // namespace vkpt
