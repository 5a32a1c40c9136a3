// Paths that pixels share: the image stays what it is, and noise falls by as much as there are pixels.
// Neighbours err alike, so that the error of a mean is told by several runs, not by the pixels.
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::test {
namespace {

constexpr int kSize = 16;
constexpr int kRuns = 32;

EstimatorSettings shared(std::uint32_t pixels, EstimatorSettings settings = misSampling()) {
  settings.pathReuse = pixels;
  return settings;
}

/// Means of a render with other random numbers each time: of the whole image and of its four columns, each a
/// film of one pixel and one sample a run.
std::vector<Film> overRuns(Trial& t, const Scene& scene, const EstimatorSettings& e, std::uint64_t frames) {
  std::vector<Film> means(5, Film{1, 1, std::vector<PixelMoments>(1)});
  const RenderSetup setup = t.complete({.estimator = e, .width = kSize, .height = kSize, .frames = frames});
  selftest::Studio studio(t.context(), scene, setup);
  for (std::uint32_t run = 0; run < kRuns; ++run) {
    studio.integrator().restart(setup.seed + run);
    const selftest::Rendered r = studio.render();
    t.expect(r.counters.faults() == 0, fmt::format("{} faults", r.counters.faults()));
    for (int i = 0; i < 5; ++i) {
      const Film part = i == 0 ? r.film : columns(r.film, (i - 1) * kSize / 4, kSize / 4);
      means[static_cast<std::size_t>(i)].pixels[0].merge({1, estimateOf(part).mean, Vec3d(0.0)});
    }
  }
  return means;
}

void expectSameMeans(Trial& t, const std::vector<Film>& a, const std::vector<Film>& b, double tolerance,
                     const std::string& what) {
  for (std::size_t i = 0; i < a.size(); ++i)
    t.expectEqualMeans(a[i], b[i], i == 0 ? tolerance : 2.0 * tolerance,
                       what + (i == 0 ? "" : fmt::format(", column {}", i)));
}

/// Walls and blocks of all sizes: pixels side by side see other things and have other things in between.
SceneBuilder clutter() {
  SceneBuilder builder;
  builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse({0.8F, 0.6F, 0.4F}));
  builder.ceiling({0.1, 0.98, -0.1}, 0.5, emitter({4.0F, 3.0F, 2.0F}));
  for (int i = 0; i < 6; ++i) {
    const double x = -0.8 + 0.3 * i;
    builder.box({x, -1.0, -0.7 + 0.2 * (i % 3)}, {x + 0.1, -0.6 + 0.25 * (i % 4), 0.1 + 0.2 * (i % 2)},
                Facing::Outward, diffuse({0.3F, 0.5F + 0.05F * static_cast<float>(i), 0.8F}));
  }
  builder.camera(lookAt({0.0, 0.4, 0.95}, {0.0, -0.3, -0.2}, 100.0));
  return builder;
}

/// By light sampling alone, weighted, and by BSDF sampling alone with roulette that ends paths at x1.
void clutterShared(Trial& t) {
  const Scene scene = clutter().build();
  const std::vector<Film> alone = overRuns(t, scene, misSampling(), 16);
  expectSameMeans(t, overRuns(t, scene, shared(16), 16), alone, 0.02, "16 pixels");
  expectSameMeans(t, overRuns(t, scene, shared(4, lightSampling()), 16), alone, 0.02, "4, light sampling");
  EstimatorSettings ending = shared(64);
  ending.roulette = RouletteMode::Albedo;
  ending.rouletteAfter = 1;
  expectSameMeans(t, overRuns(t, scene, ending, 16), alone, 0.02, "64, roulette by albedo");
}

/// Everything glows: Le / (1 - albedo) wherever the camera looks.
void furnaceShared(Trial& t) {
  const Vec3f albedo(0.7F, 0.5F, 0.3F);
  const Vec3f emission(1.0F, 2.0F, 3.0F);
  const Scene scene =
      SceneBuilder()
          .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse(albedo, emission))
          .box({-0.6, -1.0, -0.4}, {0.1, 0.2, 0.3}, Facing::Outward, diffuse(albedo, emission))
          .camera(lookAt({0.3, 0.6, 0.9}, {0.0, -0.4, 0.0}, 90.0))
          .build();
  for (const LightStrategy light : {LightStrategy::Mis, LightStrategy::Bsdf}) {
    const Film mean = overRuns(t, scene, shared(16, findingLightBy(light)), 8)[0];
    t.expectMean(mean, Vec3d(emission) / (Vec3d(1.0) - Vec3d(albedo)), 0.02,
                 light == LightStrategy::Mis ? "weighted" : "by chance");
  }
}

/// Light from a mirror that goes on from wall to wall, found from both ends by a camera in a corner, to which
/// the near walls are large and the far ones small.
void causticsShared(Trial& t) {
  SceneBuilder builder;
  builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse({0.9F, 0.8F, 0.7F}));
  builder.quad({-0.6, 0.3, -0.6}, {0.6, 0.3, -0.6}, {0.6, 0.3, 0.6}, {-0.6, 0.3, 0.6}, emitter(Vec3f(9.0F)));
  builder.floor({0.0, -0.9, 0.0}, 0.8, mirror(Vec3f(0.9F)));
  builder.camera(lookAt({0.9, 0.9, 0.9}, {0.0, 0.6, 0.0}, 100.0));
  const auto of = [](EstimatorSettings e) {
    e.pathKinds = (1U << static_cast<std::uint32_t>(PathKind::Caustic)) |
                  (1U << static_cast<std::uint32_t>(PathKind::IndirectCaustic));
    return e;
  };
  EstimatorSettings both = of(shared(64));
  both.lightTracing = LightTracing::On;
  const Scene scene = builder.build();
  expectSameMeans(t, overRuns(t, scene, both, 96), overRuns(t, scene, of(misSampling()), 192), 0.02,
                  "caustics");
}

/// Two cells, seen from above, of which the left one has a lamp; pixels of both share paths, and none may
/// bring light through the wall between them, nor lose any for it.
void cellsShared(Trial& t) {
  SceneBuilder builder;
  constexpr double kTop = -0.2;
  for (const double x : {-1.0, 0.5, 1.0}) {
    builder.quad({x, -1.0, -1.0}, {x, -1.0, 1.0}, {x, kTop, 1.0}, {x, kTop, -1.0}, diffuse(Vec3f(0.8F)));
    builder.quad({x, -1.0, 1.0}, {x, -1.0, -1.0}, {x, kTop, -1.0}, {x, kTop, 1.0}, diffuse(Vec3f(0.8F)));
  }
  builder.floor({0.0, -1.0, 0.0}, 1.0, diffuse(Vec3f(0.8F)));
  builder.quad({-0.99, -0.8, -0.5}, {-0.99, -0.4, -0.5}, {-0.99, -0.4, 0.5}, {-0.99, -0.8, 0.5},
               emitter(Vec3f(20.0F)));
  builder.camera(lookAt({0.0, 1.5, 0.0}, {0.0, -1.0, 0.0}, 46.0, {0.0, 0.0, -1.0}));
  const Scene scene = builder.build();
  EstimatorSettings e = shared(64);
  e.pathKinds = 1U << static_cast<std::uint32_t>(PathKind::Indirect);
  const Film once = t.render(scene, {.estimator = e, .width = kSize, .height = kSize, .frames = 64}).film;
  t.expect(estimateOf(columns(once, kSize - 2, 2)).mean == Vec3d(0.0), "the cell without a lamp is lit");
  EstimatorSettings alone = e;
  alone.pathReuse = 1;
  expectSameMeans(t, overRuns(t, scene, e, 64), overRuns(t, scene, alone, 256), 0.02, "cells");
}

/// With all kinds of surfaces and lights, textures, a filter, glass that splits no path.
void everythingShared(Trial& t) {
  const Scene scene = everything();
  EstimatorSettings e = shared(16);
  e.lightSelection = LightSelection::Tree;
  e.specularSamples = 2;
  e.lightSamples = 2;
  expectSameMeans(t, overRuns(t, scene, e, 32), overRuns(t, scene, misSampling(), 32), 0.03, "everything");
}

/// What a path must remember of having been shared, and what it has brought until then.
void carriedShared(Trial& t) {
  t.expectSameWhenCarried(glowingRoom(), {.estimator = shared(4), .width = 8, .height = 8, .frames = 16});
}

/// Of light that has been to another wall, whose noise is all in what is shared, and of walls that see about
/// the same.
void noiseIsShared(Trial& t) {
  SceneBuilder builder;
  builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse(Vec3f(0.7F)));
  builder.ceiling({0.0, 0.98, 0.0}, 0.8, emitter(Vec3f(10.0F)));
  builder.camera(lookAt({0.0, 0.0, 0.5}, {0.0, 0.0, -1.0}, 40.0));
  const auto varianceOf = [&](std::uint32_t pixels) {
    RenderSetup setup{.estimator = shared(pixels), .width = 64, .height = 64, .frames = 16};
    setup.estimator.pathKinds = 1U << static_cast<std::uint32_t>(PathKind::Indirect);
    return sampleVariance(t.render(builder.build(), setup).film).x;
  };
  const double alone = varianceOf(1);
  for (const std::uint32_t pixels : {4U, 16U, 64U}) {
    const double gain = alone / varianceOf(pixels);
    t.expect(gain > 0.7 * pixels && gain < 1.6 * pixels,
             fmt::format("{} pixels: variance smaller by {:.3g}", pixels, gain));
  }
}

constexpr Check kReuseChecks[] = {
    {"clutterShared", clutterShared},   {"furnaceShared", furnaceShared},
    {"causticsShared", causticsShared}, {"everythingShared", everythingShared},
    {"cellsShared", cellsShared},       {"carriedShared", carriedShared},
    {"noiseIsShared", noiseIsShared},
};

} // namespace

std::span<const Check> reuseChecks() { return kReuseChecks; }

} // namespace vkpt::test
