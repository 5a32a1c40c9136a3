#pragma once

#include "core/math.h"

#include <cstdint>

namespace vkpt {

/// Cubes of space, by which directions are guided (device/guide.h) and lights chosen (device/light_grid.h).
struct CubeGrid {
  Vec3f lower{0.0F}; ///< corner, in local coordinates
  float cubesPerMetre = 0.0F;
  std::uint32_t edge = 0; ///< cubes along it; 0: there is none
};

/// About a box, which may be flat or a point, with `edge` cubes along its longest side.
CubeGrid gridAbout(const Box3d& box, std::uint32_t edge);

} // namespace vkpt
