#include "device/cube_grid.h"

#include <algorithm>

namespace vkpt {

CubeGrid gridAbout(const Box3d& box, std::uint32_t edge) {
  const Vec3d extent = box.extent();
  const double longest =
      std::max({extent.x, extent.y, extent.z, 1e-6 * glm::length(box.upper), 1e-30}) * 1.001;
  return {Vec3f(box.centre() - 0.5 * longest), static_cast<float>(edge / longest), edge};
}

} // namespace vkpt
