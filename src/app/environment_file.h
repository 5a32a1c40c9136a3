#pragma once
#include "scene/scene.h"

namespace vkpt {

/// Reads `scene.environment.file`, if there is one, into its radiance: .hdr, .exr or .pfm, linear. Throws
/// SceneError for a file that can't be read, and for a pixel that is negative or not finite.
void readEnvironment(Scene& scene);

} // namespace vkpt
