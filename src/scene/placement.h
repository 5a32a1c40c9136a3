#pragma once
// Where the assignment's framework puts its meshes and its camera; OBJ files say neither.

#include "core/math.h"
#include "scene/scene.h"

#include <string_view>

namespace vkpt {

/// world = rotate(position * scale) + offset. The rotation is about y.
struct Placement {
  double scale = 1.0;
  double cosine = 1.0;
  double sine = 0.0;
  Vec3d offset{0.0};
  std::string_view note; ///< for the report; empty: the file is taken as it is

  [[nodiscard]] Vec3d direction(const Vec3d& d) const {
    return {cosine * d.x + sine * d.z, d.y, cosine * d.z - sine * d.x};
  }
  [[nodiscard]] Vec3d position(const Vec3d& p) const { return direction(p * scale) + offset; }
};

/// By how the file's name starts, in any case.
Placement placementFor(std::string_view fileName);

/// Looks along -z at the centre of the box from 1.75 half diagonals away, image plane of height 1 at
/// distance 1.
Camera fitCamera(const Box3d& box);

} // namespace vkpt
