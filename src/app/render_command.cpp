// The default command: load, build, compile, render, write.

#include "app/commands.h"
#include "app/environment_file.h"
#include "app/interrupt.h"
#include "app/outputs.h"
#include "app/progress.h"
#include "app/run_report.h"
#include "core/clock.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

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

Scene loadWithOverrides(const RenderOptions& o, SceneReport& report) {
  Scene scene = loadScene(o.scenes, report);
  applyOverrides(scene, o);
  readEnvironment(scene);
  if (!hasLight(scene)) {
    report.warnings.push_back(fmt::format(
        "{}: no light: no material emits (Ke, or the framework's Ka) and there is no --background; "
        "the image will be black",
        scene.name));
  }
  for (const auto& warning : report.warnings) {
    if (o.strict)
      throw Error(ExitCode::Scene, warning + " (an error by --strict)");
    spdlog::warn("{}", warning);
  }
  return scene;
}

RenderJob withDefaults(RenderJob job, const Scene& scene) {
  if (!job.frames && !job.seconds && !job.targetError)
    job.frames = static_cast<std::uint64_t>(scene.defaultFrames);
  return job;
}

ExitCode conclude(const RenderOptions& o, const RunReport& report, const gpu::Context& context) {
  if (o.log != LogLevel::Quiet)
    fmt::print("{}", summaryText(report, o.outputs));
  if (context.validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  if (report.counters.faults() > 0) {
    spdlog::error("{}: {}; the image is wrong there", report.scene, faultText(report.counters));
    return ExitCode::Faults;
  }
  return report.result.stop == StopReason::User ? ExitCode::Interrupted : ExitCode::Done;
}

} // namespace

ExitCode runRender(const RenderOptions& o) {
  checkOutputs(o);
  const InterruptGuard interrupts;
  RunReport report;
  Stopwatch watch;

  const Scene scene = loadWithOverrides(o, report.sceneReport);
  checkOutputSizes(o, scene.width, scene.height);
  const RenderJob job = withDefaults(o.job, scene);
  const EstimatorSettings estimator = estimatorFor(o, scene);
  for (const auto& line : describeOptions(o, job, scene, estimator))
    spdlog::debug("{}", line);
  report.seconds.load = watch.restart();

  const EffectSet effects = detectEffects(scene, estimator);
  const gpu::Context context({o.device, o.validation});
  watch.restart();
  const PackedScene packed = packScene(scene, estimator);
  const DeviceScene deviceScene = uploadScene(context, packed);
  report.seconds.build = watch.restart();

  Integrator integrator(context, deviceScene, scene, effects,
                        {estimator, scene.width, scene.height, o.seed, {}, {}});
  integrator.warmUp();
  report.seconds.compile = watch.restart();

  Film film;
  {
    ProgressLine progress(o.progress);
    report.result = renderUntil(integrator, film, job, progress);
  }
  report.seconds.render = report.result.seconds;
  report.scene = scene.name;
  report.width = scene.width;
  report.height = scene.height;
  report.counters = integrator.counters();
  report.film = filmStatistics(film);
  report.tail = estimateTail(film);
  report.effects = effects.names();
  report.device = context.info().name;
  report.seed = o.seed;
  report.deviceBytes = deviceScene.bytes() + integrator.filmBytes();
  report.bias = biasOf(o, estimator);
  if (report.counters.faults() > 0 && report.result.stop != StopReason::User)
    report.result.stop = StopReason::Fault;

  watch.restart();
  writeImages(o, report, film, integrator.kindImages(film));
  report.seconds.output = watch.restart();
  writeStats(o, report);
  return conclude(o, report, context);
}

} // namespace vkpt
