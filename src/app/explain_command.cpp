// vkpt explain [SCENE...]: what is compiled in for a scene, because of what, and what it takes.

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/expanded_options.h"
#include "app/explain_report.h"
#include "app/load_scene.h"
#include "host/learn_guide.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace vkpt {

ExitCode runExplain(const RenderOptions& o) {
  ExplainReport report;
  SceneReport sceneReport;
  const Scene scene = loadSceneFor(o, sceneReport);
  const EstimatorSettings estimator = estimatorFor(o, scene);
  report.reasons = explainEffects(scene, estimator);
  report.compiled = effectsFor(o, report.reasons.set, sceneReport);
  const gpu::Context context({o.device, o.validation, pipelineCacheFolder()});
  const PackedScene packed = packGuided(scene, estimator, report.compiled);
  noteLeftOut(packed.leftOut, sceneReport);

  report.scene = scene.name;
  report.triangles = packed.bvh.triangleOrder.size();
  report.width = scene.width;
  report.height = scene.height;
  report.device = context.info().name;
  report.notes = sceneReport.notes;
  for (const EffectInfo& e : allEffects()) {
    report.bytes.push_back(effectBytes(e.effect, packed, report.compiled, estimator, scene.width,
                                       scene.height, o.job.tileBlocks));
  }
  report.memory =
      planMemory(context, packed, report.compiled, estimator, scene.width, scene.height, o.job.tileBlocks);
  if (o.measure) {
    report.costs =
        measureEffectCosts(context, scene, packGuided(scene, estimator, EffectSet::all()), estimator,
                           report.compiled, report.costSettings, [&o](const EffectCost& cost) {
                             if (o.progress)
                               spdlog::info("measured {}", effectName(cost.effect));
                           });
  }
  fmt::print("{}", o.json ? explainJson(report) : explainText(report));
  if (context.validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  return ExitCode::Done;
}

} // namespace vkpt
