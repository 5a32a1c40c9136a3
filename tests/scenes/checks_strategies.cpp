// Light sampling, BSDF sampling and both, weighted: one integral, and what each costs in variance.
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

/// One point of a floor under a light so large that both strategies find every part of it with densities of
/// one size: what a wrong weight adds or takes away is large.
LitFloor underLargeLight() {
  const Vec3d light[4] = {{-2.0, 1.0, -3.0}, {3.0, 1.0, -3.0}, {3.0, 1.0, 2.5}, {-2.0, 1.0, 2.5}};
  const Vec3f radiance(3.0F, 2.0F, 1.0F);
  const Scene scene = SceneBuilder()
                          .quad(light[0], light[1], light[2], light[3], emitter(radiance))
                          .floor(Vec3d(0.0), 0.3, diffuse(kAlbedo))
                          .camera(lookAt({-0.5, 0.8, 0.1}, Vec3d(0.0), kPointFov))
                          .build();
  const double irradiance = polygonIrradiance({light[0], light[1], light[2], light[3]}, Vec3d(0.0), kUp);
  return {scene, Vec3d(kAlbedo) * Vec3d(radiance) * (irradiance / std::numbers::pi)};
}

void litFloorByMis(Trial& t) {
  for (const LitFloor& lit : {underLargeLight(), litFloor()})
    t.expectMean(renderAt(t, lit.scene, misSampling(), 40), lit.radiance, 0.006);
}

/// Several light samples are averaged: one mean, and a variance that falls with their number.
void lightSamplesAverage(Trial& t) {
  const LitFloor lit = litFloor();
  Vec3d single(0.0);
  for (const std::uint32_t n : {1U, 4U, 16U}) {
    EstimatorSettings settings = lightSampling();
    settings.lightSamples = n;
    const Film film = renderAt(t, lit.scene, settings, 40);
    t.expectMean(film, lit.radiance, 0.005, fmt::format("{} light samples", n));
    if (n == 1)
      single = sampleVariance(film);
    const double ratio = sampleVariance(film).x / single.x * n;
    // 160 000 samples tell a variance to about 0.4 %.
    t.expect(std::abs(ratio - 1.0) < 0.04,
             fmt::format("{} light samples have {:.3f}/{} of the variance of 1", n, ratio, n));
  }
}

void lightSamplesByMis(Trial& t) {
  const LitFloor lit = underLargeLight();
  for (const std::uint32_t n : {4U, 16U}) {
    EstimatorSettings settings = misSampling();
    settings.lightSamples = n;
    t.expectMean(renderAt(t, lit.scene, settings, 40), lit.radiance, 0.006,
                 fmt::format("{} light samples", n));
  }
}

/// A light that stands on the floor, lit and seen at grazing angles only.
void grazingLight(Trial& t) {
  const Vec3d light[4] = {{1.0, 0.0, -1.0}, {1.0, 0.0, 1.0}, {1.0, 0.1, 1.0}, {1.0, 0.1, -1.0}};
  const Scene scene = SceneBuilder()
                          .floor(Vec3d(0.0), 3.0, diffuse(kAlbedo))
                          .quad(light[0], light[1], light[2], light[3], emitter(Vec3f(10.0F)))
                          .camera(lookAt({-0.5, 0.8, 0.1}, Vec3d(0.0), kPointFov))
                          .build();
  const double irradiance = polygonIrradiance({light[0], light[1], light[2], light[3]}, Vec3d(0.0), kUp);
  for (const EstimatorSettings& settings : {lightSampling(), misSampling()}) {
    t.expectMean(renderAt(t, scene, withBounces(settings, 1), 40),
                 Vec3d(kAlbedo) * (10.0 / std::numbers::pi * irradiance), 0.01);
  }
}

/// A light of a micrometre's edge a kilometre away, and one of a thousand kilometres a metre away: densities
/// whose squares are no floats.
void extremeLights(Trial& t) {
  constexpr double kEdge = 1e-6;
  const float radiance = 1e18F;
  const Scene tiny =
      SceneBuilder()
          .floor({0.0, -1000.0, 0.0}, 1.0, diffuse(kAlbedo))
          .floor({0.0, 1000.0, 0.0}, 1.0, diffuse(Vec3f(0.0F))) // the light is the scene's middle
          .triangle({0.0, 0.0, 0.0}, {kEdge, 0.0, 0.0}, {0.0, 0.0, kEdge}, emitter(Vec3f(radiance)))
          .camera(lookAt({0.0, -999.0, 1.0}, {0.0, -1000.0, 0.0}, kPointFov))
          .build();
  const double far = 0.5 * kEdge * kEdge * double{radiance} * 1e-6;
  const double half = 1e6;
  const Scene huge = SceneBuilder()
                         .ceiling({0.0, 1.0, 0.0}, half, emitter(Vec3f(1.0F)))
                         .floor(Vec3d(0.0), 0.5, diffuse(kAlbedo))
                         .floor({0.0, -1.0, 0.0}, half, diffuse(Vec3f(0.0F)))
                         .camera(lookAt({-0.4, 0.7, 0.1}, Vec3d(0.0), kPointFov))
                         .build();
  for (const EstimatorSettings& settings : {lightSampling(), misSampling()}) {
    t.expectMean(renderAt(t, tiny, settings, 4), Vec3d(kAlbedo) * (far / std::numbers::pi), 0.001, "tiny");
  }
  t.expectMean(renderAt(t, huge, misSampling(), 4), Vec3d(kAlbedo), 0.01, "huge");
}

/// An albedo above 1 gains energy; survival stays a probability.
void albedoAboveOne(Trial& t) {
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 1.0, diffuse({1.3F, 1.0F, 0.5F}))
      .camera(lookAt({-0.5, 0.8, 0.1}, Vec3d(0.0), 20.0))
      .background(Vec3f(1.0F));
  for (const RouletteMode mode : {RouletteMode::Throughput, RouletteMode::Albedo}) {
    EstimatorSettings settings = bsdfSampling(mode);
    settings.rouletteAfter = 1;
    const Film film = renderAt(t, builder.build(), settings, 16);
    if (mode == RouletteMode::Throughput)
      t.expectConstant(film, Vec3d(1.3F, 1.0F, 0.5F), 0, "albedo 1.3");
    else
      t.expectMean(film, Vec3d(1.3F, 1.0F, 0.5F), 0.01, "albedo 1.3");
  }
}

// --- strategies against each other ---

/// Three strips of a floor, each a third of the image: diffuse, and two glossy ones that mirror the light.
constexpr int kStrips = 3;
constexpr int kStripEdge = 16;
SceneBuilder strips(const std::array<Material, kStrips>& materials) {
  SceneBuilder builder;
  for (int i = 0; i < kStrips; ++i) {
    const double x = 0.4 * i - 0.6;
    builder.quad({x, 0.0, 0.5}, {x + 0.4, 0.0, 0.5}, {x + 0.4, 0.0, -0.5}, {x, 0.0, -0.5},
                 materials[static_cast<std::size_t>(i)]);
  }
  builder.camera(lookAt({0.0, 1.2, 1.5}, Vec3d(0.0), 34.0));
  return builder;
}
SceneBuilder glossyStrips() {
  return strips({diffuse(kAlbedo), phong({0.2F, 0.1F, 0.3F}, {0.7F, 0.6F, 0.5F}, 100.0F),
                 phong({0.3F, 0.4F, 0.1F}, {0.5F, 0.4F, 0.6F}, 5.0F)});
}
SceneBuilder& addSquare(SceneBuilder& builder, const Vec3d& centre, double h, const Vec3f& radiance) {
  const Vec3d u(h, 0.0, 0.0);
  const Vec3d v = h * glm::normalize(Vec3d(0.0, -centre.z, centre.y)); // faces the origin where x is 0
  return builder.quad(centre - u - v, centre + u - v, centre + u + v, centre - u + v, emitter(radiance));
}

void expectAgreement(Trial& t, const Scene& scene, std::uint64_t frames, double tolerance) {
  const auto with = [&](LightStrategy light) {
    return t
        .render(scene, {.estimator = findingLightBy(light),
                        .width = kStrips * kStripEdge,
                        .height = kStripEdge,
                        .frames = light == LightStrategy::Bsdf ? 2 * frames : frames})
        .film;
  };
  const Film nee = with(LightStrategy::Nee);
  const Film bsdf = with(LightStrategy::Bsdf);
  const Film mis = with(LightStrategy::Mis);
  for (int i = 0; i < kStrips; ++i) {
    const auto strip = [&](const Film& film) { return columns(film, i * kStripEdge, kStripEdge); };
    t.expectEqualMeans(strip(nee), strip(mis), tolerance, fmt::format("strip {}: nee against mis", i));
    t.expectEqualMeans(strip(bsdf), strip(mis), tolerance, fmt::format("strip {}: bsdf against mis", i));
  }
}

void strategiesUnderSmallLight(Trial& t) {
  SceneBuilder builder = glossyStrips();
  addSquare(builder, {0.0, 1.2, -1.5}, 0.2, {3.0F, 2.0F, 1.0F});
  expectAgreement(t, builder.build(), 1000, 0.05);
}
void strategiesUnderLargeLight(Trial& t) {
  SceneBuilder builder = glossyStrips();
  addSquare(builder, {0.0, 1.2, -1.5}, 1.1, {3.0F, 2.0F, 1.0F});
  expectAgreement(t, builder.build(), 400, 0.04);
}
void strategiesUnderSeveralLights(Trial& t) {
  SceneBuilder builder = glossyStrips();
  addSquare(builder, {0.0, 1.2, -1.5}, 0.3, {3.0F, 2.0F, 1.0F});
  addSquare(builder, {0.0, 2.0, -0.3}, 0.5, {0.5F, 1.0F, 2.0F});
  addSquare(builder, {0.0, 0.7, 2.5}, 0.6, {1.0F, 1.0F, 0.5F});
  expectAgreement(t, builder.background(Vec3f(0.1F)).build(), 400, 0.04);
}
void strategiesUnderEnvironment(Trial& t) {
  Scene scene = glossyStrips().build();
  scene.environment = environmentMap(8, 4, [](int column, int row) {
    return row == 1 && column == 4
               ? Vec3f(4.0F, 3.0F, 2.0F)
               : Vec3f(0.2F, 0.1F * static_cast<float>(row + 1), 0.05F * static_cast<float>(column + 1));
  });
  expectAgreement(t, scene, 800, 0.04);
}

/// Rough metal, glass and Nori's coat: the light above them, or the sky, or what shines through.
void strategiesOnRoughSurfaces(Trial& t) {
  SceneBuilder builder =
      strips({microfacet({0.3F, 0.2F, 0.1F}, 0.3F, 1.5F),
              roughMetal({0.2F, 0.9F, 1.1F}, {3.9F, 2.5F, 2.2F}, 0.2F), roughGlass(1.5F, 0.3F)});
  addSquare(builder, {0.0, 1.2, -1.5}, 0.5, {3.0F, 2.0F, 1.0F});
  addSquare(builder, {0.2, -1.5, -0.7}, 0.4, {0.5F, 1.0F, 3.0F});
  Scene scene = builder.build();
  scene.environment = environmentMap(6, 4, [](int column, int row) {
    return Vec3f(0.1F * static_cast<float>(column), 0.2F * static_cast<float>(row), 0.2F);
  });
  expectAgreement(t, scene, 800, 0.06);
}

/// A closed room, a light near its ceiling, glossy and diffuse.
void strategiesInRoom(Trial& t) {
  SceneBuilder builder;
  builder.box(Vec3d(-1.0), Vec3d(1.0), Facing::Inward, diffuse({0.6F, 0.5F, 0.4F}))
      .ceiling({-0.3, 0.7, -0.2}, 0.4, emitter(Vec3f(4.0F)))
      .box({0.1, -1.0, -0.8}, {0.7, -0.3, -0.2}, Facing::Outward, phong(Vec3f(0.3F), Vec3f(0.5F), 30.0F))
      .camera(lookAt({-0.7, 0.3, 0.9}, {0.3, -0.3, -0.4}, 70.0));
  const auto with = [&](LightStrategy light, std::uint64_t frames) {
    return t
        .render(builder.build(),
                {.estimator = findingLightBy(light), .width = 32, .height = 32, .frames = frames})
        .film;
  };
  const Film mis = with(LightStrategy::Mis, 128);
  t.expectEqualMeans(with(LightStrategy::Nee, 128), mis, 0.03, "nee against mis");
  t.expectEqualMeans(with(LightStrategy::Bsdf, 256), mis, 0.03, "bsdf against mis");
}

/// The last vertex of a path that may not scatter again still looks for what it can hit.
void bounceLimitsByStrategy(Trial& t) {
  SceneBuilder builder; // a room without its front wall, under a sky
  builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse({0.6F, 0.5F, 0.4F}));
  builder.ceiling({-0.3, 0.7, -0.2}, 0.5, emitter({3.0F, 2.0F, 1.0F}))
      .camera(lookAt({0.2, 0.1, 0.9}, {-0.1, -0.3, -0.4}, 80.0))
      .background({0.5F, 0.7F, 1.0F});
  Scene scene = builder.build();
  scene.triangles.erase(scene.triangles.begin() + 10, scene.triangles.begin() + 12); // box(): +z is the last
  for (const std::uint32_t bounces : {0U, 1U, 2U, 3U}) {
    const double tolerance = bounces == 0 ? 0.04 : 0.02; // the lamp covers a small part of the image
    const auto with = [&](LightStrategy light, std::uint64_t frames) {
      const EstimatorSettings settings = withBounces(findingLightBy(light), bounces);
      return t.render(scene, {.estimator = settings, .width = 32, .height = 32, .frames = frames}).film;
    };
    const Film mis = with(LightStrategy::Mis, 96);
    t.expectEqualMeans(with(LightStrategy::Nee, 96), mis, tolerance,
                       fmt::format("{} bounces, nee against mis", bounces));
    t.expectEqualMeans(with(LightStrategy::Bsdf, 160), mis, tolerance,
                       fmt::format("{} bounces, bsdf against mis", bounces));
  }
}

/// Veach's case: a lobe far narrower than the light, and a light far smaller than a lobe. The weighted sum is
/// never much worse than the better of the two, however bad the other one is.
void misIsNeverMuchWorse(Trial& t) {
  struct Case {
    const char* name;
    double size;
    float exponent;
  };
  for (const Case& c :
       {Case{"large light, narrow lobe", 0.8, 1000.0F}, Case{"small light, wide lobe", 0.02, 20.0F}}) {
    const Material m = phong(Vec3f(0.0F), Vec3f(0.9F), c.exponent);
    SceneBuilder builder = strips({m, m, m});
    addSquare(builder, {0.0, 1.2, -1.5}, c.size, Vec3f(1.0F));
    std::array<double, 3> variance{};
    for (std::size_t i = 0; i < variance.size(); ++i) {
      const RenderSetup setup{.estimator = withBounces(findingLightBy(kStrategies[i].light), 1),
                              .width = 24,
                              .height = 24,
                              .frames = 400};
      variance[i] = sampleVariance(t.render(builder.build(), setup).film).x;
    }
    const auto [nee, bsdf, mis] = variance;
    const std::string figures =
        fmt::format("{}: variances of nee {:.3g}, bsdf {:.3g}, mis {:.3g}", c.name, nee, bsdf, mis);
    t.expect(mis < 2.0 * std::min(nee, bsdf), figures);
    t.expect(mis < 0.2 * std::max(nee, bsdf), figures);
  }
}

/// As carriedPaths: what a path must remember to weigh the emission it meets.
void carriedDensities(Trial& t) {
  const Scene scene = furnace(Vec3f(0.99F));
  t.expectSameWhenCarried(scene, {.estimator = misSampling(), .width = 8, .height = 8, .frames = 16});
}

constexpr Check kStrategyChecks[] = {
    {"litFloorByMis", litFloorByMis},
    {"lightSamplesByMis", lightSamplesByMis},
    {"lightSamplesAverage", lightSamplesAverage},
    {"carriedDensities", carriedDensities},
    {"grazingLight", grazingLight},
    {"extremeLights", extremeLights},
    {"albedoAboveOne", albedoAboveOne},
    {"misIsNeverMuchWorse", misIsNeverMuchWorse},
    {"strategiesUnderLargeLight", strategiesUnderLargeLight},
    {"strategiesUnderEnvironment", strategiesUnderEnvironment},
    {"strategiesUnderSeveralLights", strategiesUnderSeveralLights},
    {"strategiesUnderSmallLight", strategiesUnderSmallLight},
    {"strategiesOnRoughSurfaces", strategiesOnRoughSurfaces},
    {"strategiesInRoom", strategiesInRoom},
    {"bounceLimitsByStrategy", bounceLimitsByStrategy},
};

} // namespace

std::span<const Check> strategyChecks() { return kStrategyChecks; }

} // namespace vkpt::test
