#include "app/expanded_options.h"

#include "app/option_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vkpt {
namespace {

std::string kindList(std::uint32_t kinds) {
  std::vector<std::string_view> names;
  for (std::uint32_t i = 0; i < kPathKindCount; ++i) {
    if (((kinds >> i) & 1U) != 0U)
      names.push_back(kKindNames[i]);
  }
  return fmt::format("{}", fmt::join(names, ","));
}

std::string rouletteText(const EstimatorSettings& e) {
  if (e.roulette == RouletteMode::Constant)
    return fmt::format("constant={:g}", e.termination);
  return std::string(nameOf(kRouletteNames, e.roulette));
}

} // namespace

double horizontalFov(const Camera& c, double aspect) {
  if (c.fovAxis == Camera::FovAxis::Horizontal)
    return c.fovDegrees;
  constexpr double kDegree = std::numbers::pi / 180.0;
  return 2.0 * std::atan(std::tan(0.5 * c.fovDegrees * kDegree) * aspect) / kDegree;
}

std::string_view pathKindName(PathKind kind) { return nameOf(kKindNames, kind); }

PixelFilter namedFilter(PixelFilter::Shape shape) {
  PixelFilter filter;
  filter.shape = shape;
  switch (shape) {
  case PixelFilter::Shape::Box:
    filter.radius = 0.5;
    break;
  case PixelFilter::Shape::Tent:
    filter.radius = 1.0;
    break;
  case PixelFilter::Shape::Gaussian:
  case PixelFilter::Shape::Mitchell:
    filter.radius = 2.0;
    break;
  }
  return filter;
}

EstimatorSettings estimatorFor(const RenderOptions& o, const Scene& scene) {
  EstimatorSettings e = o.estimator;
  e.light = o.light.value_or(scene.defaults.light.value_or(e.light));
  e.maxBounces = o.maxBounces.value_or(scene.defaults.maxBounces.value_or(e.maxBounces));
  e.pathKinds = o.pathKinds.value_or(scene.defaults.pathKinds.value_or(e.pathKinds));
  if (e.roulette == RouletteMode::Constant && e.termination >= 1.0) {
    // Roulette itself would end the last vertex's ray for emission too, which a limit on bounces still
    // traces.
    e.maxBounces = std::min(e.maxBounces, e.effectiveRouletteAfter());
    e.roulette = RouletteMode::Throughput;
    e.rouletteAfter = e.maxBounces + 1;
  }
  return e;
}

std::vector<std::string> biasOf(const RenderOptions& o, const EstimatorSettings& e) {
  std::vector<std::string> bias;
  if (o.estimator.roulette == RouletteMode::Constant && o.estimator.termination >= 1.0)
    bias.push_back(fmt::format("--roulette constant=1 (--max-bounces {})", e.maxBounces));
  else if (e.maxBounces != kUnlimitedBounces)
    bias.push_back(fmt::format("--max-bounces {}", e.maxBounces));
  if (e.pathKinds != kAllPathKinds)
    bias.push_back("--paths " + kindList(e.pathKinds));
  return bias;
}

std::vector<std::string> describeOptions(const RenderOptions& o, const RenderJob& job, const Scene& scene,
                                         const EstimatorSettings& e) {
  const auto vector = [](const auto& v) { return fmt::format("{:g},{:g},{:g}", v.x, v.y, v.z); };
  std::vector<std::string> lines;
  const auto say = [&]<class... Values>(fmt::format_string<Values...> text, Values&&... values) {
    lines.push_back(fmt::format(text, std::forward<Values>(values)...));
  };
  if (job.frames)
    say("--frames {}", *job.frames);
  if (job.seconds)
    say("--time {}", *job.seconds);
  if (job.targetError)
    say("--target-error {}", *job.targetError);
  if (o.pilotSeconds)
    say("--pilot {}", *o.pilotSeconds);
  say("--batch {} --tile-blocks {}", job.batch, job.tileBlocks);
  say("--size {}x{}", scene.width, scene.height);
  for (const auto& path : o.outputs)
    say("--output {}", path.string());
  say("--exposure {} --tonemap {}", o.display.exposureStops, nameOf(kTonemapNames, o.display.tonemap));
  say("--look-at {},{} --up {} --fov {:g}", vector(scene.camera.eye), vector(scene.camera.target),
      vector(scene.camera.up), horizontalFov(scene.camera, static_cast<double>(scene.width) / scene.height));
  say("--light {} --max-bounces {}", nameOf(kLightNames, e.light),
      e.maxBounces == kUnlimitedBounces ? "inf" : std::to_string(e.maxBounces));
  say("--light-samples {} --split {} --paths {}", e.lightSamples, e.splitDepth, kindList(e.pathKinds));
  if (!o.kindPrefix.empty())
    say("--output-paths {}", o.kindPrefix.string());
  say("--roulette {} --roulette-after {}", rouletteText(e), e.effectiveRouletteAfter());
  say("--effects {}", effectsText(o.effects));
  say("--filter {}", nameOf(kFilterNames, scene.filter.shape));
  say("--light-selection {}", nameOf(kLightSelectionNames, e.lightSelection));
  say("--light-tracing {} --guiding {} --specular-samples {} --path-reuse {}",
      nameOf(kLightTracingNames, e.lightTracing), nameOf(kGuidingNames, e.guiding), e.specularSamples,
      e.pathReuse);
  say("--sampler {} --seed {} --background {}", nameOf(kSamplerNames, e.sampler), o.seed,
      vector(scene.background));
  if (!scene.environment.file.empty())
    say("--environment {}", scene.environment.file.string());
  if (!o.device.empty())
    say("--device {}", o.device);
  if (!o.stats.empty())
    say("--stats {}", o.stats.string());
  if (o.strict)
    say("--strict");
  if (o.validation)
    say("--validation");
  return lines;
}

} // namespace vkpt
