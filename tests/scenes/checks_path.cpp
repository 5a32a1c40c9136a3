// Whole paths: furnaces, bounce limits, roulette, estimators that must agree, random numbers.
#include "scenes/check.h"

#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

/// Every path has the same value, so a limit of n bounces gives 1 + a + ... + a^n exactly.
void furnaceByBounces(Trial& t) {
  const Vec3d albedo(0.5, 0.25, 0.75);
  const Scene scene = furnace(albedo);
  Vec3d expected(1.0);
  Vec3d term(1.0);
  for (const std::uint32_t bounces : {0U, 1U, 2U, 3U}) {
    const EstimatorSettings settings = withBounces(withoutRoulette(bsdfSampling()), bounces);
    const Film film = t.render(scene, {.estimator = settings, .frames = 4}).film;
    t.expectConstant(film, expected, 0, fmt::format("{} bounces", bounces)); // dyadic: no rounding at all
    term *= albedo;
    expected += term;
  }
}

/// Direct light is one bounce, by light sampling too.
void directByBounces(Trial& t) {
  const LitFloor lit = litFloor();
  const auto at = [&](std::uint32_t bounces) {
    return t.render(
        lit.scene,
        {.estimator = withBounces(lightSampling(), bounces), .width = 64, .height = 64, .frames = 40});
  };
  t.expectConstant(at(0).film, Vec3d(0.0), 0, "no bounce");
  t.expectMean(at(1).film, lit.radiance, 0.005, "one bounce");
}

/// Grey: survival by the mean of the channels would give a much brighter one an infinite variance.
void furnaceByAlbedo(Trial& t) {
  const Film film =
      t.render(furnace(Vec3f(0.5F)),
               {.estimator = bsdfSampling(RouletteMode::Albedo), .width = 64, .height = 64, .frames = 48})
          .film;
  t.expectMean(film, Vec3d(2.0), 0.005);
}

void neeAgainstBsdf(Trial& t) {
  const Scene scene = twoLightRoom();
  const auto with = [&](const EstimatorSettings& settings, std::uint64_t frames) {
    return t.render(scene, {.estimator = settings, .width = 32, .height = 32, .frames = frames}).film;
  };
  t.expectEqualMeans(with(lightSampling(), 128), with(bsdfSampling(), 512), 0.02, "nee against bsdf");
}

/// One point of a floor. Its direct light comes from one of two triangles of equal power, one near, one far;
/// its indirect light from a ceiling above it that only directions near the normal meet.
constexpr float kGrey = 0.8F;
constexpr double kCeilingHalfEdge = 0.9;
constexpr float kTriangleRadiance = 5.0F;
constexpr Vec3d kTriangles[2][3] = {{{1.4, 0.3, -0.3}, {1.4, 0.3, 0.3}, {1.4, 0.7, 0.0}},
                                    {{-6.0, 0.3, 0.3}, {-6.0, 0.3, -0.3}, {-6.0, 0.7, 0.0}}};

Scene floorAndCeiling() {
  SceneBuilder builder;
  builder.floor({0.0, 0.0, 0.0}, 0.2, diffuse(Vec3f(kGrey)))
      .ceiling({0.0, 1.0, 0.0}, kCeilingHalfEdge, diffuse(Vec3f(kGrey)))
      .camera(lookAt({-0.5, 0.8, 0.1}, {0.0, 0.0, 0.0}, kPointFov));
  for (const auto& corners : kTriangles)
    builder.triangle(corners[0], corners[1], corners[2], emitter(Vec3f(kTriangleRadiance)));
  return builder.build();
}

/// Radiance by direct light at `p` with normal `n`.
double directOfTriangles(const Vec3d& p, const Vec3d& n) {
  double irradiance = 0.0;
  for (const auto& corners : kTriangles)
    irradiance += double{kTriangleRadiance} * polygonIrradiance({corners[0], corners[1], corners[2]}, p, n);
  return double{kGrey} / std::numbers::pi * irradiance;
}

/// Two bounces against the closed form for the first and midpoint quadrature over the ceiling for the second.
void twoBouncesByNee(Trial& t) {
  constexpr int kCells = 200;
  constexpr double kEdge = 2.0 * kCeilingHalfEdge / kCells;
  double irradiance = 0.0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const Vec3d q((i + 0.5) * kEdge - kCeilingHalfEdge, 1.0, (j + 0.5) * kEdge - kCeilingHalfEdge);
      const double r2 = glm::dot(q, q); // both cosines are 1 / r
      irradiance += directOfTriangles(q, {0.0, -1.0, 0.0}) / (r2 * r2) * kEdge * kEdge;
    }
  }
  const double expected =
      directOfTriangles(Vec3d(0.0), {0.0, 1.0, 0.0}) + double{kGrey} / std::numbers::pi * irradiance;
  const Film film =
      t.render(floorAndCeiling(),
               {.estimator = withBounces(lightSampling(), 2), .width = 64, .height = 64, .frames = 160})
          .film;
  t.expectMean(film, Vec3d(expected), 0.01);
}

/// Roulette after the first vertex: its number stands beside the BSDF's.
EstimatorSettings endingByAlbedo(std::uint32_t bounces) {
  EstimatorSettings settings = withBounces(lightSampling(), bounces);
  settings.roulette = RouletteMode::Albedo;
  return settings;
}

/// A floor lit by way of a ceiling, by a strip close under the ceiling that leads far away: of its points
/// only the near ones matter. Whether a path survives the floor says nothing of the point that the ceiling
/// looks at.
void rouletteAndNextLightIndependent(Trial& t) {
  const Scene scene =
      SceneBuilder()
          .floor({0.0, 0.0, 0.0}, 0.2, diffuse(Vec3f(0.5F)))
          .ceiling({0.0, 1.0, 0.0}, 0.5, diffuse(Vec3f(0.5F)))
          .triangle({-0.1, 0.9, -0.1}, {-0.1, 0.9, 0.1}, {5.0, 0.9, 0.0}, emitter(Vec3f(1.0F)))
          .camera(lookAt({0.0, 0.5, 0.0}, Vec3d(0.0), 10.0, {0.0, 0.0, 1.0}))
          .build();
  const auto with = [&](const EstimatorSettings& e) {
    return t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = 2048}).film;
  };
  t.expectEqualMeans(with(endingByAlbedo(2)), with(withoutRoulette(withBounces(lightSampling(), 2))), 0.06,
                     "two bounces");
}

/// With the same seed, with a background and without, the difference of a pixel's two values is what a path
/// finds that has survived the first vertex: roulette's number, beside the BSDF's, is independent of those
/// that choose a point of the strip, of which only the near ones matter.
void lightAndBsdfIndependent(Trial& t) {
  const auto with = [&](float background) {
    const Scene scene =
        SceneBuilder()
            .floor({0.0, 0.0, 0.0}, 0.2, diffuse(Vec3f(0.5F)))
            .triangle({-0.1, 0.3, -0.1}, {5.0, 0.3, 0.0}, {-0.1, 0.3, 0.1}, emitter(Vec3f(1.0F)))
            .camera(lookAt({0.0, 0.2, 0.0}, Vec3d(0.0), 10.0, {0.0, 0.0, 1.0}))
            .background(Vec3f(background))
            .build();
    return t
        .render(scene, {.estimator = endingByAlbedo(1),
                        .width = 64,
                        .height = 64,
                        .frames = 1,
                        .seed = seedOf("lightAndBsdfIndependent")})
        .film;
  };
  const Film direct = with(0.0F);
  const Film both = with(1.0F);
  std::vector<double> d;
  std::vector<double> i;
  for (std::size_t p = 0; p < direct.pixels.size(); ++p) {
    d.push_back(direct.pixels[p].mean.x);
    i.push_back(both.pixels[p].mean.x - direct.pixels[p].mean.x);
  }
  const double r = correlation(d, i);
  const double bound = 4.5 / std::sqrt(static_cast<double>(d.size()));
  t.expect(std::abs(r) < bound,
           fmt::format("direct light and the background correlate: {:.3f}, bound {:.3f}", r, bound));
}

/// Paths that outlast a dispatch: with as many samples a batch as there can be, or one. All walls emit, so
/// that whatever a path forgets on the way shows at once (light sampling's variance is infinite here; bits
/// don't mind).
void carriedPaths(Trial& t) {
  const Scene scene = furnace(Vec3f(0.999F));
  t.expectSameWhenCarried(scene, {.estimator = lightSampling(), .width = 8, .height = 8, .frames = 16});
}

constexpr Check kPathChecks[] = {
    {"furnaceByBounces", furnaceByBounces},
    {"directByBounces", directByBounces},
    {"lightAndBsdfIndependent", lightAndBsdfIndependent},
    {"rouletteAndNextLightIndependent", rouletteAndNextLightIndependent},
    {"twoBouncesByNee", twoBouncesByNee},
    {"furnaceByAlbedo", furnaceByAlbedo},
    {"carriedPaths", carriedPaths},
    {"neeAgainstBsdf", neeAgainstBsdf},
};

} // namespace

Scene twoLightRoom() {
  return SceneBuilder()
      .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse({0.6F, 0.5F, 0.4F}))
      .ceiling({-0.4, 0.7, -0.3}, 0.35, emitter({4.0F, 4.0F, 4.0F}))
      .floor({0.5, -0.6, 0.4}, 0.25, emitter({1.0F, 3.0F, 6.0F}))
      .box({0.1, -1.0, -0.8}, {0.6, -0.2, -0.2}, Facing::Outward, diffuse({0.3F, 0.6F, 0.6F}))
      .camera(lookAt({-0.7, 0.3, 0.9}, {0.3, -0.3, -0.4}, 70.0))
      .build();
}

std::span<const Check> pathChecks() { return kPathChecks; }

} // namespace vkpt::test
