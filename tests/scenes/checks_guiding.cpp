// Guided directions: the image stays what it is, and what they are for has less noise.
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

namespace vkpt::test {
namespace {

EstimatorSettings guided() {
  EstimatorSettings settings = misSampling();
  settings.lightTracing = LightTracing::On;
  settings.guiding = Guiding::Auto;
  return settings;
}

/// Straight down into a mirror that shows the ceiling, to which a lamp in it shines by way of the mirror
/// alone.
Scene mirroredCeiling() {
  return SceneBuilder()
      .floor({0.0, 0.0, 0.0}, 1.5, mirror({0.9F, 0.8F, 0.7F}))
      .ceiling({0.0, 1.0, 0.0}, 1.5, diffuse({0.7F, 0.5F, 0.3F}))
      .ceiling({0.0, 0.99, 0.0}, 0.25, emitter(Vec3f(5.0F)))
      .camera(lookAt({0.9, 0.6, 0.0}, {0.9, 0.0, 0.0}, 38.0, {0.0, 0.0, -1.0}))
      .build();
}

void guidedByTheMirror(Trial& t) {
  const Scene scene = mirroredCeiling();
  const auto with = [&](const EstimatorSettings& e, std::uint64_t frames) {
    return t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = frames}).film;
  };
  const Film byGuide = with(guided(), 512);
  const Film byBsdf = with(misSampling(), 4096);
  t.expectEqualMeans(byGuide, byBsdf, 0.05, "the ceiling");
  for (int i = 0; i < 4; ++i)
    t.expectEqualMeans(columns(byGuide, 8 * i, 8), columns(byBsdf, 8 * i, 8), 0.1,
                       fmt::format("columns from {}", 8 * i));
  const double ratio = sampleVariance(byGuide).x / sampleVariance(byBsdf).x;
  t.atMost("variance over that by BSDF sampling", ratio, 1.0 / 3.0);
}

/// Everything emits and nothing but the walls absorbs: Le / (1 - albedo) wherever the camera looks.
void furnaceByGuide(Trial& t) {
  const Vec3f albedo(0.5F, 0.4F, 0.3F);
  const Vec3f emission(3.0F, 2.0F, 1.0F);
  const Scene scene = furnaceWithSolids(albedo, emission, lookAt({0.0, -0.3, 0.9}, {0.0, -0.5, 0.0}, 60.0));
  for (const RouletteMode roulette : {RouletteMode::Throughput, RouletteMode::Albedo}) {
    EstimatorSettings e = guided();
    e.roulette = roulette;
    const Film film = t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = 256}).film;
    t.expectMean(film, Vec3d(emission) / (Vec3d(1.0) - Vec3d(albedo)), 0.02,
                 roulette == RouletteMode::Albedo ? "by albedo" : "by throughput");
  }
}

/// Every other kind of surface and light beside them, and several paths behind the specular ones.
void varietyByGuide(Trial& t) {
  Scene scene = variety();
  for (Material& m : scene.materials)
    m.absorption = Vec3f(0.0F); // paths from the lights can't go together with it
  const auto with = [&](const EstimatorSettings& e) {
    return t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = 256}).film;
  };
  EstimatorSettings several = guided();
  several.specularSamples = 3;
  t.expectEqualMeans(with(several), with(misSampling()), 0.03, "the image");
}

void carriedByGuide(Trial& t) {
  t.expectSameWhenCarried(mirroredCeiling(),
                          {.estimator = guided(), .width = 24, .height = 24, .frames = 16});
}

constexpr Check kGuidingChecks[] = {
    {"guidedByTheMirror", guidedByTheMirror},
    {"furnaceByGuide", furnaceByGuide},
    {"varietyByGuide", varietyByGuide},
    {"carriedByGuide", carriedByGuide},
};

} // namespace

std::span<const Check> guidingChecks() { return kGuidingChecks; }

} // namespace vkpt::test
