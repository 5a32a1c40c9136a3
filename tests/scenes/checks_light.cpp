// Emission and direct light against closed forms.
#include "scenes/check.h"

#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

/// A camera beside the light that looks at the origin of the floor.
Camera floorCamera() { return lookAt({-3.0, 2.0, 1.0}, {0.0, 0.0, 0.0}, kPointFov); }

/// The light of litFloor(): convex, of two triangles in the ratio 1 : 2.7, off to the side.
constexpr Vec3d kLight[4] = {{0.3, 1.4, -0.6}, {1.5, 1.4, -0.9}, {1.9, 1.4, 1.1}, {0.2, 1.4, 0.9}};

SceneBuilder& addLight(SceneBuilder& builder) {
  return builder.quad(kLight[0], kLight[1], kLight[2], kLight[3], emitter(kRadiance));
}

void emitterSeen(Trial& t) {
  const Scene scene = SceneBuilder()
                          .floor({0.0, 0.0, 0.0}, 1.0, emitter(kRadiance))
                          .camera(lookAt({0.1, 2.0, 0.2}, {0.0, 0.0, 0.0}, 30.0))
                          .build();
  for (const EstimatorSettings& settings : {lightSampling(), bsdfSampling()})
    t.expectConstant(t.render(scene, {.estimator = settings, .frames = 40}).film, kRadiance, 0, "front");
}

void emitterBack(Trial& t) {
  const Scene scene = SceneBuilder()
                          .ceiling({0.0, 0.0, 0.0}, 1.0, emitter(kRadiance))
                          .camera(lookAt({0.1, 2.0, 0.2}, {0.0, 0.0, 0.0}, 30.0))
                          .build();
  t.expectConstant(t.render(scene, {}).film, Vec3d(0.0), 0, "back");
}

void litFromBehind(Trial& t) {
  const Scene scene = SceneBuilder()
                          .floor({0.0, 0.0, 0.0}, 1.0, diffuse(kAlbedo))
                          .floor({0.2, 1.0, 0.1}, 0.5, emitter(kRadiance))
                          .camera(floorCamera())
                          .build();
  for (const EstimatorSettings& settings : {lightSampling(), bsdfSampling()})
    t.expectConstant(t.render(scene, {.estimator = settings}).film, Vec3d(0.0), 0, "under a light's back");
}

void backgroundOnly(Trial& t) {
  const Vec3f radiance(0.25F, 0.5F, 1.5F);
  const Scene scene = SceneBuilder()
                          .floor({0.0, -1.0, 5.0}, 1.0, diffuse(kAlbedo))
                          .camera(lookAt({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 60.0))
                          .background(radiance)
                          .build();
  t.expectConstant(t.render(scene, {.frames = 20}).film, radiance, 0, "background");
}

/// An emitter whose right edge leaves three tenths of a column's pixels and whose lower edge lies between two
/// rows: which pixels are lit, and with what share of their samples.
void imageLayout(Trial& t) {
  const Scene scene = SceneBuilder()
                          .quad({-9.0, 0.0, -1.0}, {0.15, 0.0, -1.0}, {0.15, 9.0, -1.0}, {-9.0, 9.0, -1.0},
                                emitter(kRadiance))
                          .camera(lookAt({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 90.0))
                          .build();
  const std::uint64_t frames = 4000;
  const Film film = t.render(scene, {.width = 4, .height = 4, .frames = frames}).film;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      const double seen = film.at(x, y).mean.x / kRadiance.x;
      const double share = y >= 2 || x == 3 ? 0.0 : (x == 2 ? 0.3 : 1.0);
      // A binomial share; the rows' border may be off by rounding.
      const double error = x == 2 ? std::sqrt(share * (1.0 - share) / static_cast<double>(frames)) : 1e-6;
      t.expect(std::abs(seen - share) <= 4.0 * error,
               fmt::format("pixel ({}, {}) sees the emitter with {:.4f} of its samples, expected {}", x, y,
                           seen, share));
    }
  }
}

void litFloorByNee(Trial& t) {
  const LitFloor lit = litFloor();
  const Film film =
      t.render(lit.scene, {.estimator = lightSampling(), .width = 64, .height = 64, .frames = 40}).film;
  t.expectMean(film, lit.radiance, 0.005);
}

void litFloorByBsdf(Trial& t) {
  const LitFloor lit = litFloor();
  const Film film =
      t.render(lit.scene, {.estimator = bsdfSampling(), .width = 64, .height = 64, .frames = 160}).film;
  t.expectMean(film, lit.radiance, 0.01);
}

void shadowed(Trial& t) {
  SceneBuilder builder;
  addLight(builder).floor({0.0, 0.0, 0.0}, 1.0, diffuse(kAlbedo)).camera(floorCamera());
  builder.ceiling({0.8, 0.7, 0.0}, 0.85, diffuse(Vec3f(0.0F)));
  for (const EstimatorSettings& settings : {lightSampling(), bsdfSampling()}) {
    t.expectConstant(t.render(builder.build(), {.estimator = settings}).film, Vec3d(0.0), 0,
                     "behind a blocker");
  }
}

/// A weak light near by and a strong one far off, the first rarely chosen though most of the light is its.
void unequalLights(Trial& t) {
  const Vec3d near[] = {{0.2, 0.5, -0.1}, {0.4, 0.5, -0.1}, {0.4, 0.5, 0.1}, {0.2, 0.5, 0.1}};
  const Vec3d far[] = {{9.0, 9.0, -2.0}, {13.0, 9.0, -2.0}, {13.0, 9.0, 2.0}, {9.0, 9.0, 2.0}};
  const Vec3f farRadiance(0.05F, 0.05F, 0.2F);
  SceneBuilder builder;
  builder.quad(near[0], near[1], near[2], near[3], emitter(kRadiance))
      .quad(far[0], far[1], far[2], far[3], emitter(farRadiance))
      .floor({0.0, 0.0, 0.0}, 1.0, diffuse(kAlbedo))
      .camera(floorCamera());
  const Film film =
      t.render(builder.build(), {.estimator = lightSampling(), .width = 64, .height = 64, .frames = 400})
          .film;
  const Vec3d irradiance =
      Vec3d(kRadiance) * polygonIrradiance({near[0], near[1], near[2], near[3]}, Vec3d(0.0), kUp) +
      Vec3d(farRadiance) * polygonIrradiance({far[0], far[1], far[2], far[3]}, Vec3d(0.0), kUp);
  t.expectMean(film, Vec3d(kAlbedo) * irradiance / std::numbers::pi, 0.02);
}

/// A floor made twice, and a light flush with a ceiling: neither twin may shade the other.
void coincidentTwins(Trial& t) {
  SceneBuilder builder;
  builder.floor({0.0, 0.0, 0.0}, 1.0, diffuse(kAlbedo)).floor({0.0, 0.0, 0.0}, 1.0, diffuse(kAlbedo));
  addLight(builder).ceiling({1.0, kLight[0].y, 0.0}, 1.3, diffuse(Vec3f(0.0F))).camera(floorCamera());
  const Film film =
      t.render(builder.build(), {.estimator = lightSampling(), .width = 64, .height = 64, .frames = 40}).film;
  t.expectMean(film, litFloor().radiance, 0.005);
}

/// The twins in a plane of coordinate 0, where that coordinate says nothing of how others round.
void twinsInPlaneZero(Trial& t) {
  SceneBuilder builder;
  builder.floor({0.0, 0.0, 0.0}, 30.0, diffuse(kAlbedo)).floor({0.0, 0.0, 0.0}, 30.0, diffuse(kAlbedo));
  builder.floor({0.0, -kLight[0].y, 0.0}, 1.0, diffuse(Vec3f(0.0F))); // the origin stays the middle
  addLight(builder).camera(floorCamera());
  for (const EstimatorSettings& settings : {lightSampling(), bsdfSampling()}) {
    const Film film =
        t.render(builder.build(), {.estimator = settings, .width = 64, .height = 64, .frames = 160}).film;
    t.expectMean(film, litFloor().radiance, 0.01);
  }
}

constexpr Check kLightChecks[] = {
    {"emitterSeen", emitterSeen},           {"emitterBack", emitterBack},
    {"litFromBehind", litFromBehind},       {"backgroundOnly", backgroundOnly},
    {"imageLayout", imageLayout},           {"shadowed", shadowed},
    {"litFloorByNee", litFloorByNee},       {"coincidentTwins", coincidentTwins},
    {"twinsInPlaneZero", twinsInPlaneZero}, {"unequalLights", unequalLights},
    {"litFloorByBsdf", litFloorByBsdf},
};

} // namespace

LitFloor litFloor(double scale, const Vec3d& offset) {
  SceneBuilder builder;
  addLight(builder).floor({0.0, 0.0, 0.0}, 1.0, diffuse(kAlbedo)).camera(floorCamera());
  const double irradiance = polygonIrradiance({kLight[0], kLight[1], kLight[2], kLight[3]}, Vec3d(0.0), kUp);
  return {builder.build(scale, offset), Vec3d(kAlbedo) * Vec3d(kRadiance) * (irradiance / std::numbers::pi)};
}

std::span<const Check> lightChecks() { return kLightChecks; }

} // namespace vkpt::test
