#include "unit/host/boxes.h"

#include "scene/load.h"

namespace vkpt::test {

CornellScene cornellBox(const std::string& name, int size, std::uint32_t seed) {
  const std::vector<fs::path> blocks{"CornellBox.obj", "CornellBlocks.obj"};
  const std::vector<fs::path> spheres{"CornellBox.obj", "CornellLeftSphere.obj", "CornellRightSphere.obj"};
  SceneReport report;
  CornellScene box;
  box.name = name;
  box.scene = loadScene(name == "blocks" ? blocks : spheres, report);
  box.settings = {{}, size, size, seed};
  box.effects = detectEffects(box.scene, box.settings.estimator);
  box.packed = packScene(box.scene, {}, 1);
  return box;
}

} // namespace vkpt::test
