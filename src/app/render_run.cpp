#include "app/render_run.h"

#include "app/expanded_options.h"
#include "app/load_scene.h"
#include "app/option_names.h"
#include "core/clock.h"
#include "host/learn_guide.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>

namespace vkpt {
namespace {

RenderJob jobOf(const RenderOptions& o, const Scene& scene) {
  RenderJob job = o.job;
  if (!o.endless && !job.frames && !job.seconds && !job.targetError)
    job.frames = static_cast<std::uint64_t>(scene.defaultFrames);
  return job;
}

} // namespace

RunReport reportOf(const RenderOptions& o, const PreparedRun& p) {
  RunReport report;
  report.scene = p.scene.name;
  report.width = p.scene.width;
  report.height = p.scene.height;
  report.targetError = p.job.targetError;
  report.sampler = nameOf(kSamplerNames, p.estimator.sampler);
  report.seed = o.seed;
  report.arguments = o.arguments;
  report.sceneReport = p.sceneReport;
  report.seconds.load = p.loadSeconds;
  report.effects = p.effects.names();
  report.bias = biasOf(o, p.estimator);
  std::ranges::move(effectsBias(o.effects, p.detected), std::back_inserter(report.bias));
  return report;
}

void addFilm(RunReport& report, const Integrator& integrator, const Film& film) {
  report.width = film.width;
  report.height = film.height;
  report.seconds.render = report.result.seconds;
  report.counters = integrator.counters();
  report.faults = integrator.faults();
  report.film = filmStatistics(film);
  report.tail = estimateTail(film);
  if (report.counters.faults() > 0 && report.result.stop != StopReason::User)
    report.result.stop = StopReason::Fault;
}

PreparedRun prepareRun(const RenderOptions& o) {
  PreparedRun p;
  const Stopwatch watch;
  p.scene = loadSceneFor(o, p.sceneReport);
  checkOutputSizes(o, p.scene.width, p.scene.height);
  p.job = jobOf(o, p.scene);
  p.estimator = estimatorFor(o, p.scene);
  for (const auto& line : describeOptions(o, p.job, p.scene, p.estimator))
    spdlog::debug("{}", line);
  p.loadSeconds = watch.seconds();
  p.detected = detectEffects(p.scene, p.estimator);
  p.effects = effectsFor(o, p.detected, p.sceneReport);
  return p;
}

FinishedRun renderRun(const RenderOptions& o, const PreparedRun& p, const gpu::Context& context,
                      RenderObserver& observer) {
  FinishedRun run{reportOf(o, p), {}, {}};
  RunReport& report = run.report;
  report.device = context.info().name;
  Stopwatch watch;
  const PackedScene packed = packGuided(p.scene, p.estimator, p.effects);
  noteLeftOut(packed.leftOut, report.sceneReport);
  const DeviceScene deviceScene = uploadScene(context, packed);
  report.seconds.build = watch.restart();

  Integrator integrator(context, deviceScene, p.scene, p.effects,
                        {p.estimator, p.scene.width, p.scene.height, o.seed, {}, {}});
  integrator.warmUp();
  report.seconds.compile = watch.restart();

  report.result = renderUntil(integrator, run.film, p.job, observer);
  report.deviceBytes = deviceScene.bytes() + integrator.filmBytes();
  addFilm(report, integrator, run.film);
  if (p.estimator.kindImages)
    run.kinds = integrator.kindImages(run.film);
  return run;
}

} // namespace vkpt
