// Long paths and roulette: means, variances, and what ends a path.
#include "scene/load.h"
#include "selftest/case.h"
#include "selftest/scene_builder.h"
#include "selftest/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vkpt::selftest {
namespace {

/// A thousand bounces a path: any cap on their number, or on the probability to go on, shows.
void longPaths(Trial& t) {
  constexpr float kAlbedo = 0.999F;
  const Rendered r = t.render(furnace(Vec3f(kAlbedo)),
                              {.estimator = bsdfSampling(), .width = 64, .height = 64, .frames = 2});
  t.expectMean(r.film, Vec3d(1.0 / (1.0 - double{kAlbedo})), 0.04);
  t.note("paths of 8192 that the far cap ended",
         static_cast<double>(r.counters.cappedPaths)); // 0.999^10000: 0.4
}

/// Survival by albedo gives every vertex the value 1 and a geometric number of them: mean 1 / (1 - a),
/// variance a / (1 - a)^2, excess kurtosis 6 + (1 - a)^2 / a.
void rouletteVariance(Trial& t) {
  constexpr double kAlbedo = 0.5;
  const Rendered r =
      t.render(furnace(Vec3f(kAlbedo)),
               {.estimator = bsdfSampling(RouletteMode::Albedo), .width = 64, .height = 64, .frames = 32});
  const double n = 64.0 * 64.0 * 32.0;
  t.expectMean(r.film, Vec3d(1.0 / (1.0 - kAlbedo)), 0.02);
  double variance = 0.0;
  for (const PixelMoments& p : r.film.pixels)
    variance += p.m2.x / static_cast<double>(p.count - 1) / static_cast<double>(r.film.pixels.size());
  const double exact = kAlbedo / ((1.0 - kAlbedo) * (1.0 - kAlbedo));
  const double kurtosis = 9.0 + (1.0 - kAlbedo) * (1.0 - kAlbedo) / kAlbedo;
  t.atMost("variance: standard errors off",
           std::abs(variance / exact - 1.0) / std::sqrt((kurtosis - 1.0) / n), 4.5,
           fmt::format("{:.6g}, expected {:.6g}", variance, exact));
  const double rays = static_cast<double>(r.counters.raysClosest) / n;
  t.atMost("rays a path: standard errors off", std::abs(rays - 2.0) / std::sqrt(exact / n), 4.5,
           fmt::format("{:.6g}, expected 2", rays));
}

/// Each channel's survivors stand for those that ended.
void rouletteByChannel(Trial& t) {
  const Vec3d albedo(0.2, 0.5, 0.95);
  const Film film =
      t.render(furnace(Vec3f(albedo)), {.estimator = bsdfSampling(), .width = 64, .height = 64, .frames = 64})
          .film;
  t.expectMean(film, 1.0 / (1.0 - Vec3d(Vec3f(albedo))), 0.01);
}

/// A floor in a room whose walls emit and reflect nothing: behind a wall there is nothing left to divide.
void blackWalls(Trial& t) {
  const Scene scene = SceneBuilder()
                          .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, emitter(Vec3f(1.0F)))
                          .floor({0.0, -0.5, 0.0}, 0.9, diffuse(Vec3f(0.5F)))
                          .camera(lookAt({0.1, 0.5, 0.2}, {0.0, -0.5, 0.0}, kPointFov))
                          .build();
  for (const RouletteMode mode : {RouletteMode::Throughput, RouletteMode::Albedo}) {
    EstimatorSettings settings = bsdfSampling(mode);
    settings.rouletteAfter = 0;
    const Film film = t.render(scene, {.estimator = settings, .width = 64, .height = 64, .frames = 8}).film;
    t.expectMean(film, Vec3d(0.5), 0.03, mode == RouletteMode::Albedo ? "by albedo" : "by throughput");
  }
}

/// What samples 0 to 15 and 2^32 to 2^32 + 15 of every pixel see.
void manySamples(Trial& t) {
  const Scene scene = SceneBuilder()
                          .floor({0.0, 0.0, 0.0}, 1.0, diffuse(Vec3f(0.5F)))
                          .ceiling({0.3, 0.7, 0.0}, 0.4, emitter(Vec3f(1.0F)))
                          .camera(lookAt({-1.0, 0.6, 0.5}, {0.0, 0.0, 0.0}, 20.0))
                          .build();
  Studio studio(t.context(), scene, t.complete({.width = 32, .height = 32}));
  const auto from = [&](std::uint64_t first) {
    studio.integrator().clear();
    studio.integrator().renderTile({0, studio.integrator().blockCount()}, first, shared::kSamplesPerGroup);
    return studio.integrator().film();
  };
  const Film early = from(0);
  const Film late = from(std::uint64_t{1} << 32U);
  std::size_t equal = 0;
  for (std::size_t i = 0; i < early.pixels.size(); ++i)
    equal += early.pixels[i].mean == late.pixels[i].mean ? 1U : 0U;
  t.atMost("pixels of 1024 that are the same", static_cast<double>(equal), 1.0);
  t.expectEqualMeans(late, early, 0.1, "after 2^32 samples");
}

constexpr Vec3d kUp(0.0, 1.0, 0.0);

/// A lamp of a tenth of a millimetre, one of 20 kilometres, and two whose powers are one to a million.
void sizesOfLights(Trial& t) {
  constexpr float kAlbedo = 0.6F;
  const auto look = [&](const char* what, double halfEdge, double height, float radiance, double tolerance) {
    const double h = halfEdge;
    const Scene scene = SceneBuilder()
                            .floor({0.0, 0.0, 0.0}, 0.5, diffuse(Vec3f(kAlbedo)))
                            .ceiling({0.0, height, 0.0}, h, emitter(Vec3f(radiance)))
                            .camera(lookAt({-0.6, 0.4, 0.1}, {0.0, 0.0, 0.0}, kPointFov))
                            .build();
    const Film film =
        t.render(scene, {.estimator = misSampling(), .width = 64, .height = 64, .frames = 32}).film;
    const double irradiance =
        double{radiance} *
        polygonIrradiance({{-h, height, -h}, {h, height, -h}, {h, height, h}, {-h, height, h}}, Vec3d(0.0),
                          kUp);
    t.expectMean(film, Vec3d(double{kAlbedo} / std::numbers::pi * irradiance), tolerance, what);
  };
  look("lamp of 1e-4", 0.5e-4, 1.0, 1e8F, 0.01);
  look("lamp of 2e4", 1e4, 10.0, 2.0F, 0.01);
}

/// Walls that emit: 1 / d^2 beside an edge has no variance for light sampling alone; weighted against BSDF
/// sampling every pixel of a corner is right.
void emittingCorner(Trial& t) {
  const Scene scene =
      SceneBuilder()
          .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse(Vec3f(0.5F), Vec3f(0.5F)))
          .camera(lookAt({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, 10.0))
          .build();
  const Film film =
      t.render(scene, {.estimator = misSampling(), .width = 32, .height = 32, .frames = 256}).film;
  t.expectMean(film, Vec3d(1.0), 0.01);
  const double bound = sidakBound(film.pixels.size());
  double worst = 0.0;
  for (const PixelMoments& p : film.pixels)
    worst = std::max(worst, std::abs(p.mean.x - 1.0) / std::sqrt(p.varianceOfMean().x));
  t.note("worst pixel: standard errors off", worst, fmt::format("a normal's bound is {:.3g}", bound));
}

/// Radiance near the largest float: what overflows is counted, and the film stays finite; what does not is
/// exact.
void extremeColours(Trial& t) {
  const auto seen = [&](float radiance, float albedo) {
    return t.renderFaulty(furnace(Vec3f(albedo), Vec3f(radiance)),
                          {.estimator = withBounces(withoutRoulette(bsdfSampling()), 1), .frames = 4});
  };
  const Rendered tiny = seen(1e-30F, 0.5F);
  t.expectConstant(tiny.film, Vec3d(1.5e-30), 4, "radiance 1e-30");
  t.expect(tiny.counters.faults() == 0, "radiance 1e-30 is a fault");
  const Rendered large = seen(1e30F, 0.5F);
  t.expectConstant(large.film, Vec3d(1.5e30), 4, "radiance 1e30");
  const Rendered over = seen(3e38F, 0.9F);
  const auto samples = static_cast<double>(over.counters.samples);
  t.atLeast("share of samples above the largest float that are counted",
            static_cast<double>(over.counters.nonFinite) / (16.0 * 16.0 * 4.0), 1.0,
            fmt::format("{} slots", samples));
  t.atLeast("faults that are recorded", static_cast<double>(over.faults.size()),
            double{shared::kMaxFaultRecords});
  double broken = 0.0;
  for (const PixelMoments& p : over.film.pixels)
    broken +=
        glm::all(glm::equal(p.mean, p.mean)) && std::isfinite(p.mean.x + p.m2.x) && p.m2.x >= 0.0 ? 0.0 : 1.0;
  t.atMost("pixels that are not finite", broken, 0.0);
}

/// A lamp seen in a silver and through a glass sphere: rare and bright. Nothing is clamped; the median of the
/// means of 16 runs, which a few bright samples don't move, agrees with their mean.
void fireflies(Trial& t) {
  SceneReport report;
  const Scene scene = loadScene(std::vector<fs::path>{"cornell-spheres"}, report);
  constexpr std::size_t kRuns = 16;
  std::vector<double> means;
  double brightest = 0.0;
  for (std::size_t i = 0; i < kRuns; ++i) {
    const Film film =
        t.render(scene, {.estimator = misSampling(), .width = 24, .height = 24, .frames = 4}).film;
    means.push_back(estimateOf(film).mean.x);
    for (const PixelMoments& p : film.pixels)
      brightest = std::max(brightest, p.mean.x);
  }
  double mean = 0.0;
  for (const double m : means)
    mean += m / kRuns;
  double squares = 0.0;
  for (const double m : means)
    squares += (m - mean) * (m - mean);
  const double error = std::sqrt(squares / (kRuns * (kRuns - 1.0)));
  std::ranges::sort(means);
  const double median = 0.5 * (means[kRuns / 2 - 1] + means[kRuns / 2]);
  t.atMost("median of the means against the mean, standard errors", std::abs(median - mean) / error, 5.0,
           fmt::format("{:.6g} against {:.6g} +- {:.2g}", median, mean, error));
  t.note("brightest pixel over the mean", brightest / mean);
}

constexpr Case kPathCases[] = {
    {"m1-long-paths", "a furnace of albedo 0.999: no cap on bounces or on survival", longPaths},
    {"m2-roulette-variance", "roulette by albedo has the mean, the variance and the rays of a geometric law",
     rouletteVariance},
    {"m3-roulette-by-channel", "channels of albedo 0.2, 0.5 and 0.95 are each unbiased", rouletteByChannel},
    {"m4-black-walls", "a throughput of 0 ends a path before anything is divided by it", blackWalls},
    {"m6-many-samples", "sample 2^32 has other random numbers than sample 0", manySamples},
    {"m10-sizes-of-lights", "lamps of 1e-4 and of 2e4 against Lambert's formula", sizesOfLights},
    {"m11-emitting-corner", "light and BSDF sampling, weighted, in a corner of walls that emit",
     emittingCorner},
    {"m12-fireflies", "rare bright paths: the median of 16 runs' means agrees with their mean", fireflies},
    {"m14-extreme-colours", "radiance from 1e-30 to 1e30 is exact; what overflows is counted, not hidden",
     extremeColours},
};

} // namespace

std::span<const Case> pathCases() { return kPathCases; }

} // namespace vkpt::selftest
