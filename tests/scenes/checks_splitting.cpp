// Splitting: at glass both branches are followed, and specular surfaces end no path.
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

EstimatorSettings splitting(std::uint32_t depth, EstimatorSettings settings = misSampling()) {
  settings.splitDepth = depth;
  return settings;
}

/// A square about the z axis in a plane of constant z; `up`: its front faces +z.
SceneBuilder& plate(SceneBuilder& builder, double z, double h, bool up, const Material& material) {
  return up ? builder.quad({-h, -h, z}, {h, -h, z}, {h, h, z}, {-h, h, z}, material)
            : builder.quad({-h, -h, z}, {-h, h, z}, {h, h, z}, {h, -h, z}, material);
}

/// A slab of glass between a red emitter on the viewer's side and a green one behind it.
SceneBuilder slab(double degrees) {
  SceneBuilder builder;
  plate(builder, 0.0, 50.0, true, glass(1.5F));
  plate(builder, -0.2, 50.0, false, glass(1.5F));
  plate(builder, 9.0, 500.0, false, emitter({1.0F, 0.0F, 0.0F}));
  plate(builder, -9.0, 500.0, true, emitter({0.0F, 1.0F, 0.0F}));
  const double a = degrees * std::numbers::pi / 180.0;
  builder.camera(lookAt({4.0 * std::sin(a), 0.0, 4.0 * std::cos(a)}, Vec3d(0.0), kPointFov));
  return builder;
}

/// Sixteen reflections hold all the light there is: a sum without chance, R + T. With fewer splits the rest
/// is left to chance, with the same mean and a smaller variance at each step.
void splitSlab(Trial& t) {
  const double degrees = 60.0;
  const double r = exactFresnelDielectric(0.5, 1.5);
  const Vec3d expected(2.0 * r / (1.0 + r), (1.0 - r) / (1.0 + r), 0.0);
  double last = 1.0;
  for (const std::uint32_t depth : {0U, 1U, 2U, 4U, 16U}) {
    const Film film = t.render(slab(degrees).build(),
                               {.estimator = splitting(depth), .width = 64, .height = 64, .frames = 32})
                          .film;
    const double variance = sampleVariance(film).y;
    t.expect(variance < last,
             fmt::format("{} splits: variance {:.3g}, with fewer {:.3g}", depth, variance, last));
    last = variance;
    if (depth < 16) {
      t.expectMean(film, expected, 0.05, fmt::format("{} splits", depth));
      continue;
    }
    // The image's angles differ by kPointFov, its reflectances by less than 1e-4 of them.
    const Estimate e = estimateOf(film);
    for (int c = 0; c < 2; ++c) {
      t.expect(std::abs(e.mean[c] / expected[c] - 1.0) < 2e-5,
               fmt::format("16 splits: {:.7g}, expected {:.7g}", e.mean[c], expected[c]));
      t.expect(std::sqrt(sampleVariance(film)[c]) < 1e-4 * expected[c],
               fmt::format("16 splits: a standard deviation of {:.2g}", std::sqrt(sampleVariance(film)[c])));
    }
  }
}

/// Radiance 1 all about: what each branch carries adds up to 1, in a box that is in another one as well.
void splitInWhite(Trial& t) {
  const Scene scene = SceneBuilder()
                          .box({-0.5, -0.4, -0.6}, {0.6, 0.5, 0.4}, Facing::Outward, glass(1.3F))
                          .box({-0.2, -0.1, -0.3}, {0.3, 0.25, 0.2}, Facing::Outward, glass(0.8F))
                          .camera(lookAt({1.5, 1.2, 2.0}, Vec3d(0.0), 40.0))
                          .background(Vec3f(1.0F))
                          .build();
  for (const std::uint32_t depth : {1U, 5U, 10U}) {
    const Film film = t.render(scene, {.estimator = splitting(depth, withoutRoulette(misSampling())),
                                       .width = 24,
                                       .height = 24,
                                       .frames = 8})
                          .film;
    double worst = 0.0;
    for (const PixelMoments& p : film.pixels)
      worst = std::max(worst, maxAbs(p.mean - Vec3d(1.0)) + std::sqrt(maxAbs(p.m2)));
    t.expect(worst < 3e-5, fmt::format("{} splits: a pixel is {:.2g} off white", depth, worst));
  }
}

/// Two mirrors face each other; the light leaves after six reflections. Roulette would end nine paths of ten
/// at each of them.
void specularsAreSpared(Trial& t) {
  EstimatorSettings settings = bsdfSampling(RouletteMode::Constant);
  settings.termination = 0.9;
  settings.rouletteAfter = 0;
  for (const Material& m : {mirror(Vec3f(0.5F)), metal(Vec3f(0.2F), Vec3f(3.0F))}) {
    SceneBuilder builder;
    plate(builder, 0.0, 3.25, true, m);
    plate(builder, 1.0, 3.25, false, m);
    builder.quad({3.5, -1.0, -9.0}, {3.5, -1.0, 9.0}, {3.5, 1.0, 9.0}, {3.5, 1.0, -9.0},
                 emitter(Vec3f(8.0F)));
    builder.camera(lookAt({-3.0, 0.0, 0.5}, {-2.5, 0.0, 0.0}, kPointFov)); // hits at x = -2.5, -1.5, ... 2.5
    const double r = m.bsdf == BsdfType::Mirror
                         ? 0.5
                         : exactFresnelConductor(std::sqrt(0.5), double{m.eta.x}, double{m.k.x});
    const Film film = t.render(builder.build(), {.estimator = splitting(6, settings), .frames = 8}).film;
    const Vec3d expected(8.0 * std::pow(r, 6));
    double worst = 0.0;
    for (const PixelMoments& p : film.pixels)
      worst = std::max(worst, maxAbs(p.mean - expected) + std::sqrt(maxAbs(p.m2)));
    t.expect(worst < 2e-4 * expected.x, fmt::format("six reflections: {:.2g} off {:.5g}", worst, expected.x));
  }
}

/// A half mirror of glass sends one branch up and one down, each to a plate before the same square of
/// darkness. Independent branches: a variance of (R^2 + T^2) p (1 - p), where a shared fate gives p (1 - p).
void branchesAreIndependent(Trial& t) {
  const double ior = (1.0 + std::numbers::sqrt2 / 2.0) / (1.0 - std::numbers::sqrt2 / 2.0); // reflects a half
  SceneBuilder builder;
  plate(builder, 0.0, 1.0, true, glass(static_cast<float>(ior)));
  plate(builder, 1.0, 0.1, false, diffuse(Vec3f(1.0F)));
  plate(builder, -1.0, 0.1, true, diffuse(Vec3f(1.0F)));
  builder.camera(lookAt({0.0, 0.0, 0.5}, Vec3d(0.0), kPointFov)).background(Vec3f(1.0F));
  const EstimatorSettings settings = splitting(1, withBounces(bsdfSampling(), 2));
  const Film film =
      t.render(builder.build(), {.estimator = settings, .width = 64, .height = 64, .frames = 40}).film;
  const double escape = 1.0 - polygonIrradiance({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                                                {0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}) /
                                  std::numbers::pi;
  t.expectMean(film, Vec3d(escape), 0.02, "light that escapes");
  const double ratio = sampleVariance(film).x / (0.5 * escape * (1.0 - escape));
  t.expect(std::abs(ratio - 1.0) < 0.03,
           fmt::format("variance is {:.3f} of that of independent branches", ratio));
}

/// Where all materials meet: one mean, however often paths are split.
void splitVariety(Trial& t) {
  const Scene scene = variety();
  const auto with = [&](std::uint32_t depth, std::uint64_t frames) {
    return t.render(scene, {.estimator = splitting(depth), .width = 32, .height = 32, .frames = frames}).film;
  };
  const Film whole = with(0, 256);
  for (const std::uint32_t depth : {1U, 2U, 4U, 16U})
    t.expectEqualMeans(with(depth, depth == 16 ? 64 : 128), whole, 0.03,
                       fmt::format("{} splits against none", depth));
}

/// Batches of many samples and of one: paths are carried to the next dispatch elsewhere, with what waits.
void carriedBranches(Trial& t) {
  SceneBuilder builder = slab(60.0);
  plate(builder, -0.5, 50.0, true, glass(1.5F));
  plate(builder, -0.8, 50.0, false, glass(1.5F));
  const Rendered whole = t.expectSameWhenCarried(
      builder.build(), {.estimator = splitting(10), .width = 8, .height = 8, .frames = 16});
  const Estimate e = estimateOf(whole.film); // an absorption-free stack: all light is red or green
  t.expect(std::abs(e.mean.x + e.mean.y - 1.0) < 0.02,
           fmt::format("the branches hold {:.6f} of the light", e.mean.x + e.mean.y));
}

constexpr Check kSplittingChecks[] = {
    {"splitSlab", splitSlab},
    {"splitInWhite", splitInWhite},
    {"specularsAreSpared", specularsAreSpared},
    {"branchesAreIndependent", branchesAreIndependent},
    {"carriedBranches", carriedBranches},
    {"splitVariety", splitVariety},
};

} // namespace

std::span<const Check> splittingChecks() { return kSplittingChecks; }

} // namespace vkpt::test
