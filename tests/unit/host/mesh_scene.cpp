#include "unit/host/mesh_scene.h"

namespace vkpt::test {

PackedScene packTriangles(std::span<const Corners> triangles) {
  Scene scene;
  scene.materials.emplace_back();
  for (const Corners& corners : triangles) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    scene.positions.insert(scene.positions.end(), corners.begin(), corners.end());
    Triangle t;
    t.vertex = {first, first + 1, first + 2};
    scene.triangles.push_back(t);
  }
  return packScene(scene, {}, 1);
}

PackedScene oneTriangle() {
  const Corners corners{Vec3f(0.0F), Vec3f(1.0F, 0.0F, 0.0F), Vec3f(0.0F, 1.0F, 0.0F)};
  return packTriangles(std::span{&corners, 1});
}

} // namespace vkpt::test
