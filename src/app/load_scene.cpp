#include "app/load_scene.h"

#include "app/environment_file.h"
#include "app/expanded_options.h"
#include "device/effects.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <tuple>

namespace vkpt {
namespace {

void applyOverrides(Scene& scene, const RenderOptions& o) {
  if (o.size)
    std::tie(scene.width, scene.height) = *o.size;
  if (o.background)
    scene.background = *o.background;
  if (!o.environment.empty()) {
    scene.environment = {};
    scene.environment.file = o.environment;
  }
  if (o.filter && *o.filter != scene.filter.shape)
    scene.filter = namedFilter(*o.filter);
  if (o.lookAt) {
    std::tie(scene.camera.eye, scene.camera.target) = *o.lookAt;
    scene.camera.mirrored = false;
  }
  if (o.up)
    scene.camera.up = *o.up;
  if (o.fovDegrees) {
    scene.camera.fovDegrees = *o.fovDegrees;
    scene.camera.fovAxis = Camera::FovAxis::Horizontal;
  }
}

bool hasLight(const Scene& scene) {
  const EffectSet effects = detectEffects(scene, {});
  return effects.has(Effect::AreaLights) || effects.has(Effect::Background) ||
         effects.has(Effect::Environment) || effects.has(Effect::DeltaLights);
}

void tellWarning(const RenderOptions& o, const std::string& warning) {
  if (o.strict)
    throw Error(ExitCode::Scene, warning + " (an error by --strict)");
  spdlog::warn("{}", warning);
}

} // namespace

Scene loadSceneFor(const RenderOptions& o, SceneReport& report) {
  Scene scene = loadScene(o.scenes, report);
  applyOverrides(scene, o);
  readEnvironment(scene);
  if (!hasLight(scene)) {
    report.warnings.push_back(fmt::format(
        "{}: no light: no material emits (Ke, or the framework's Ka) and there is no --background; "
        "the image will be black",
        scene.name));
  }
  for (const auto& warning : report.warnings)
    tellWarning(o, warning);
  return scene;
}

void warn(const RenderOptions& o, const std::string& warning, SceneReport& report) {
  report.warnings.push_back(warning);
  tellWarning(o, warning);
}

EffectSet effectsFor(const RenderOptions& o, const EffectSet& detected, SceneReport& report) {
  for (const auto& warning : effectsWarnings(o.effects, detected))
    warn(o, warning, report);
  return compiledEffects(o.effects, detected);
}

void noteLeftOut(std::size_t triangles, SceneReport& report) {
  if (triangles == 0)
    return;
  report.notes.push_back(
      fmt::format("{} triangle{} left out: glass with one index on both sides that absorbs nothing",
                  triangles, triangles == 1 ? "" : "s"));
}

} // namespace vkpt
