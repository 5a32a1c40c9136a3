#pragma once
#include "core/error.h"

namespace vkpt {

/// Where the scenes of assets/ are: beside the build folder or, once installed, in share/vkpt. Throws
/// SceneError where `file` is in neither.
fs::path assetsFolder(const fs::path& file);

} // namespace vkpt
