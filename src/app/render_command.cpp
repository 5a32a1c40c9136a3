// The default command: load, build, compile, render, write.

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/run_report.h"
#include "core/clock.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <fstream>

namespace vkpt {
namespace {

void applyOverrides(Scene& scene, const RenderOptions& o) {
  if (o.size)
    std::tie(scene.width, scene.height) = *o.size;
  if (o.background)
    scene.background = *o.background;
  if (o.lookAt)
    std::tie(scene.camera.eye, scene.camera.target) = *o.lookAt;
  if (o.up)
    scene.camera.up = *o.up;
  if (o.fovDegrees) {
    scene.camera.fovDegrees = *o.fovDegrees;
    scene.camera.fovAxis = Camera::FovAxis::Horizontal;
  }
}

Scene loadWithReport(const RenderOptions& o, SceneReport& report) {
  Scene scene = loadScene(o.scenes, report);
  for (const auto& warning : report.warnings) {
    if (o.strict)
      throw Error(ExitCode::Scene, warning + " (--strict)");
    spdlog::warn("{}", warning);
  }
  applyOverrides(scene, o);
  return scene;
}

void warnIfDark(const EffectSet& effects) {
  if (effects.has(Effect::AreaLights) || effects.has(Effect::Background))
    return;
  spdlog::warn(
      "the scene has no light: no material emits (Ke, or the framework's Ka) and there is no --background; "
      "the image will be black");
}

RenderJob withDefaults(RenderJob job, const Scene& scene) {
  if (!job.frames && !job.seconds && !job.targetError)
    job.frames = static_cast<std::uint64_t>(scene.defaultFrames);
  return job;
}

std::vector<std::string> biasOf(const RenderOptions& o) {
  std::vector<std::string> bias;
  if (o.estimator.maxBounces != kUnlimitedBounces)
    bias.push_back(fmt::format("--max-bounces {}", o.estimator.maxBounces));
  return bias;
}

/// Like the images: into a temporary file beside the target, then renamed.
void writeText(const fs::path& path, const std::string& text) {
  const fs::path temporary = path.string() + ".part";
  std::ofstream file(temporary);
  file << text;
  file.close();
  std::error_code error;
  if (file)
    fs::rename(temporary, path, error);
  if (!file || error) {
    fs::remove(temporary, error);
    throw UsageError(fmt::format("{}: cannot be written; choose another --stats file", path.string()));
  }
}

void checkStatsPath(const fs::path& path) {
  if (path.empty())
    return;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (fs::is_directory(path) || !fs::is_directory(folder)) {
    throw UsageError(fmt::format("--stats {}: not a file in a folder that exists", path.string()));
  }
}

} // namespace

ExitCode runRender(const RenderOptions& o) {
  for (const auto& line : describeOptions(o))
    spdlog::debug("{}", line);
  for (const auto& path : o.outputs)
    checkOutputPath(path);
  checkStatsPath(o.stats);
  const InterruptGuard interrupts;
  RunReport report;
  Stopwatch watch;

  SceneReport sceneReport;
  const Scene scene = loadWithReport(o, sceneReport);
  report.seconds.load = watch.restart();
  const EffectSet effects = detectEffects(scene, o.estimator);
  warnIfDark(effects);

  const gpu::Context context({o.device, o.validation});
  watch.restart();
  const PackedScene packed = packScene(scene);
  const DeviceScene deviceScene = uploadScene(context, packed);
  report.seconds.build = watch.restart();

  Integrator integrator(context, deviceScene, scene, effects,
                        {o.estimator, scene.width, scene.height, o.seed, {}, {}});
  integrator.warmUp();
  report.seconds.compile = watch.restart();

  Film film;
  {
    ProgressLine progress(o.progress);
    report.result = renderUntil(integrator, film, withDefaults(o.job, scene), progress);
  }
  report.seconds.render = report.result.seconds;
  report.scene = scene.name;
  report.width = scene.width;
  report.height = scene.height;
  report.counters = integrator.counters();
  report.film = filmStatistics(film);
  report.effects = effects.names();
  report.device = context.info().name;
  report.seed = o.seed;
  report.deviceBytes = deviceScene.bytes() + integrator.filmBytes();
  report.notes = sceneReport.notes;
  report.bias = biasOf(o);
  if (report.counters.faults() > 0 && report.result.stop != StopReason::User)
    report.result.stop = StopReason::Fault;

  watch.restart();
  const Image image = develop(film);
  for (const auto& path : o.outputs)
    writeImage(path, image, o.display, imageMetadata(report));
  report.seconds.output = watch.restart();
  if (!o.stats.empty())
    writeText(o.stats, statsJson(report));
  fmt::print("{}", summaryText(report, o.outputs));

  if (context.validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say");
  if (report.counters.faults() > 0)
    return ExitCode::Faults;
  return report.result.stop == StopReason::User ? ExitCode::Interrupted : ExitCode::Done;
}

} // namespace vkpt
