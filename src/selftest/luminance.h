#pragma once
// Luminance of linear RGB as Nori has it (sRGB primaries).

#include "core/math.h"

namespace vkpt {

inline constexpr Vec3d kLuminance{0.212671, 0.715160, 0.072169};

inline double luminanceOf(const Vec3d& colour) { return glm::dot(kLuminance, colour); }

} // namespace vkpt
