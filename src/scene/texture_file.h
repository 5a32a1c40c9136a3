#pragma once
// Image files as textures and environment maps want them.

#include "core/error.h"
#include "core/math.h"

#include <vector>

namespace vkpt {

/// Linear RGB, finite and not negative, row 0 at the top.
struct ImageFile {
  int width = 0;
  int height = 0;
  std::vector<Vec3f> texels;
};

/// PNG, JPEG, BMP and TGA are decoded from sRGB, HDR is taken as it is; the content says which it is. Throws
/// SceneError that names the file and the reason.
ImageFile readImageFile(const fs::path& path);

} // namespace vkpt
