#include "app/view/pixel_report.h"

#include "host/reference.h"
#include "host/replay.h"

#include <algorithm>

namespace vkpt {
namespace {

constexpr std::uint64_t kKindSamples = 4096; // some milliseconds

HostSettings hostSettings(const Stage& stage) {
  const IntegratorSettings& s = stage.integrator().settings();
  return {s.estimator, s.width, s.height, s.seed};
}

} // namespace

PixelReport reportPixel(const Stage& stage, const ViewSettings& settings, Vec2i pixel) {
  const PixelMoments film = stage.integrator().pixel(pixel.x, pixel.y);
  PixelReport report{pixel, film.count, film.mean, glm::sqrt(film.varianceOfMean()), {}, 0};
  if (settings.estimates()) {
    report.kindSamples = std::clamp<std::uint64_t>(film.count, 1, kKindSamples);
    report.kinds = renderPixel32(stage.packed(), stage.scene(), stage.effects(), hostSettings(stage), pixel.x,
                                 pixel.y, report.kindSamples)
                       .kinds;
  }
  return report;
}

std::optional<Vec3d> pointAt(const Stage& stage, Vec2i pixel) {
  const Replay path =
      replay64(stage.packed(), stage.scene(), stage.effects(), hostSettings(stage), pixel.x, pixel.y, 0);
  const ReplayStep& first = path.steps.front();
  if (!first.hit)
    return std::nullopt;
  return stage.scene().origin + first.origin + first.direction * first.distance;
}

} // namespace vkpt
