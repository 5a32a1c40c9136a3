// Loads the built-in Cornell box and builds the hierarchy over it, with an installed vkpt.
#include "accel/bvh.h"
#include "scene/load.h"

#include <cstdio>

int main() {
  vkpt::SceneReport report;
  const vkpt::Scene scene = vkpt::loadScene({}, report);
  std::vector<vkpt::Box3f> bounds;
  for (const vkpt::Triangle& triangle : scene.triangles) {
    vkpt::Box3f& box = bounds.emplace_back();
    for (const auto vertex : triangle.vertex)
      box.extend(scene.positions.at(vertex));
  }
  const vkpt::Bvh bvh = vkpt::buildBvh(bounds);
  const int ordered = bvh.triangleOrder.size(); // narrows on purpose: our -Wconversion -Werror stay at home
  if (ordered == 0 || bvh.triangleOrder.size() != scene.triangles.size()) {
    std::fprintf(stderr, "%zu triangles loaded, %d in the hierarchy\n", scene.triangles.size(), ordered);
    return 1;
  }
  return 0;
}
