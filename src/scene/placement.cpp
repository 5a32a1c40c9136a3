#include "scene/placement.h"

#include "scene/names.h"

#include <array>
#include <cmath>

namespace vkpt {

Placement placementFor(std::string_view fileName) {
  const std::string name = lowerCase(fileName);
  if (name.starts_with("cornell")) {
    // Half a turn in exact numbers: sin(pi) is not 0 in floating point.
    return {0.025, -1.0, 0.0, Vec3d(0.0), "Cornell rule: x0.025, turned, camera fitted"};
  }
  if (name.starts_with("bunny")) {
    return {25.0, 1.0, 0.0, Vec3d(-3.0, -0.85, -8.0), "bunny rule: x25, moved by -3 -0.85 -8, camera fitted"};
  }
  if (name.starts_with("justelephant")) {
    return {1.0, std::cos(0.5), std::sin(0.5), Vec3d(-10.0, 3.0, -2.0),
            "elephant rule: turned by 0.5 rad, moved by -10 3 -2, camera fitted"};
  }
  return {};
}

Camera fitCamera(const Box3d& box) {
  constexpr double kPi = 3.14159265358979323846;
  Camera camera;
  camera.target = box.centre();
  camera.eye = camera.target + Vec3d(0.0, 0.0, 1.75 * 0.5 * glm::length(box.extent()));
  camera.up = Vec3d(0.0, 1.0, 0.0);
  camera.fovDegrees = 2.0 * std::atan(0.5) * 180.0 / kPi;
  camera.fovAxis = Camera::FovAxis::Vertical;
  return camera;
}

} // namespace vkpt
