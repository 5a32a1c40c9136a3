// Scrambled Sobol' points: the same expectation, a smaller error, and one that is told as it is.
#include "scenes/scene_extras.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::test {
namespace {

EstimatorSettings bySobol(EstimatorSettings s) {
  s.sampler = Sampler::Sobol;
  return s;
}

/// Mean over the pixels of the squared deviation from `truth`, and of what their standard errors say it is.
struct Errors {
  double measured = 0.0;
  double predicted = 0.0;
};
Errors errorsOf(const Film& film, const Vec3d& truth) {
  Errors e;
  for (const PixelMoments& p : film.pixels) {
    const Vec3d d = p.mean - truth;
    e.measured += glm::dot(d, d) / static_cast<double>(film.pixels.size());
    const Vec3d variance = p.varianceOfMean();
    e.predicted += (variance.x + variance.y + variance.z) / static_cast<double>(film.pixels.size());
  }
  return e;
}

/// Every pixel sees one point of a lit floor. Two replicates, as few as there can be, and many samples of
/// four. The channels are multiples of each other: a pixel gives one chi-square of 1 degree, and a predicted
/// one of `replicates - 1`.
void sobolTellsItsError(Trial& t) {
  const LitFloor floor = litFloor();
  for (const std::uint64_t frames : {32U, 512U}) {
    const Film film = renderAt(t, floor.scene, bySobol({}), frames);
    const Errors e = errorsOf(film, floor.radiance);
    const double pixels = static_cast<double>(film.pixels.size());
    const double degrees = frames == 32 ? 1.0 : 3.0;
    const double bound = 5.0 * std::sqrt(2.0 / pixels + 2.0 / (degrees * pixels));
    t.atMost(fmt::format("{} frames: measured over predicted variance, off 1", frames),
             std::abs(e.measured / e.predicted - 1.0), bound);
    t.expectMean(film, floor.radiance, 0.003);
  }
}

/// A smooth integrand of two dimensions: its variance falls faster than 1 / n.
void sobolIsWorthMore(Trial& t) {
  const LitFloor floor = litFloor();
  const double independent = errorsOf(renderAt(t, floor.scene, {}, 512), floor.radiance).measured;
  const double sobol = errorsOf(renderAt(t, floor.scene, bySobol({}), 512), floor.radiance).measured;
  t.atMost("512 frames: variance, of independent samples'", sobol / independent, 0.05);
}

constexpr Check kSobolChecks[] = {
    {"sobolTellsItsError", sobolTellsItsError},
    {"sobolIsWorthMore", sobolIsWorthMore},
};

} // namespace

std::span<const Check> sobolChecks() { return kSobolChecks; }

} // namespace vkpt::test
