// The default command: load, build, compile, render, write.

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/load_scene.h"
#include "app/outputs.h"
#include "app/progress.h"
#include "app/run_report.h"
#include "core/clock.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>

namespace vkpt {
namespace {

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

  const Scene scene = loadSceneFor(o, report.sceneReport);
  checkOutputSizes(o, scene.width, scene.height);
  const RenderJob job = withDefaults(o.job, scene);
  const EstimatorSettings estimator = estimatorFor(o, scene);
  for (const auto& line : describeOptions(o, job, scene, estimator))
    spdlog::debug("{}", line);
  report.seconds.load = watch.restart();

  const EffectSet detected = detectEffects(scene, estimator);
  const EffectSet effects = effectsFor(o, detected, report.sceneReport);
  const gpu::Context context({o.device, o.validation, pipelineCacheFolder()});
  watch.restart();
  const PackedScene packed = packScene(scene, estimator, effects);
  noteLeftOut(packed.leftOut, report.sceneReport);
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
  report.faults = integrator.faults();
  report.arguments = o.arguments;
  report.film = filmStatistics(film);
  report.tail = estimateTail(film);
  report.effects = effects.names();
  report.device = context.info().name;
  report.seed = o.seed;
  report.deviceBytes = deviceScene.bytes() + integrator.filmBytes();
  report.bias = biasOf(o, estimator);
  std::ranges::move(effectsBias(o.effects, detected), std::back_inserter(report.bias));
  if (report.counters.faults() > 0 && report.result.stop != StopReason::User)
    report.result.stop = StopReason::Fault;

  watch.restart();
  writeImages(o, report, film, estimator.kindImages ? integrator.kindImages(film) : KindImages());
  report.seconds.output = watch.restart();
  writeStats(o, report);
  return conclude(o, report, context);
}

} // namespace vkpt
