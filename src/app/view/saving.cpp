#include "app/view/saving.h"

#include "app/expanded_options.h"
#include "app/outputs.h"

#include <fmt/format.h>

namespace vkpt {
namespace {

std::vector<fs::path> freeNames(const std::string& scene) {
  for (int number = 1;; ++number) {
    const fs::path png = fmt::format("{}-{}.png", scene, number);
    const fs::path exr = fmt::format("{}-{}.exr", scene, number);
    if (!fs::exists(png) && !fs::exists(exr))
      return {png, exr};
  }
}

} // namespace

RunReport reportOf(const RenderOptions& o, const PreparedRun& prepared, const Stage& stage,
                   const ViewRun& run, const Film& film) {
  PreparedRun p;
  p.estimator = stage.integrator().settings().estimator;
  p.detected = stage.detected();
  p.effects = stage.effects();
  p.sceneReport = prepared.sceneReport;
  p.loadSeconds = prepared.loadSeconds;
  p.scene.name = stage.scene().name;
  RunReport report = reportOf(o, p);
  report.device = run.device;
  report.deviceBytes = stage.deviceBytes();
  report.seconds.build = stage.buildSeconds();
  report.seconds.compile = stage.compileSeconds();
  report.result = run.result;
  addFilm(report, stage.integrator(), film);
  if (!run.settings.estimates())
    report.bias.push_back(fmt::format("shader: {}", shaderName(run.settings.shader)));
  const std::string camera =
      cameraOptions(stage.scene().camera, static_cast<double>(film.width) / static_cast<double>(film.height));
  report.sceneReport.notes.push_back("camera: " + camera);
  return report;
}

std::vector<fs::path> saveFilm(const RenderOptions& options, bool named, const PreparedRun& prepared,
                               const Stage& stage, const ViewRun& run, const Film& film) {
  RenderOptions o = options;
  o.display = run.settings.display;
  if (!named)
    o.outputs = freeNames(stage.scene().name);
  writeImages(o, reportOf(o, prepared, stage, run, film), film, {});
  return o.outputs;
}

std::string cameraOptions(const Camera& c, double aspect) {
  const auto vector = [](const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
  return fmt::format("--look-at {},{} --up {} --fov {}", vector(c.eye), vector(c.target), vector(c.up),
                     horizontalFov(c, aspect));
}

} // namespace vkpt
