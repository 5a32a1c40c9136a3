// Lights without a surface: points and directions, which no ray can hit.
#include "scenes/scene_extras.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

/// So small a field of view that irradiance does not change over it in float.
constexpr double kStillFov = 1e-5;

SceneBuilder floorAlone() {
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 1.0, diffuse(kAlbedo)).camera(lookAt({-0.5, 0.8, 0.1}, Vec3d(0.0), kStillFov));
  return builder;
}

/// The image is one value without variance, but for rounding.
void expectStill(Trial& t, const Film& film, const Vec3d& expected, const std::string& what) {
  constexpr double kRelative = 3e-6;
  for (const PixelMoments& p : film.pixels) {
    const Vec3d off = glm::abs(p.mean - expected);
    const Vec3d spread = glm::sqrt(p.m2 / static_cast<double>(p.count));
    if (glm::all(glm::lessThanEqual(off + spread, kRelative * expected)))
      continue;
    t.expect(false,
             fmt::format("{}: {:.8g} {:.8g} {:.8g} with a spread of {:.2g}, expected {:.8g} {:.8g} {:.8g}",
                         what, p.mean.x, p.mean.y, p.mean.z, spread.x, expected.x, expected.y, expected.z));
    return;
  }
}

/// E = I cos / r^2, whatever the strategy: nothing else can find the light.
void pointLight(Trial& t) {
  const Vec3d at(0.4, 1.1, -0.7);
  const Vec3f intensity(3.0F, 2.0F, 1.0F);
  Scene scene = floorAlone().build();
  addPointLight(scene, at, intensity);
  const double r2 = glm::dot(at, at);
  const Vec3d radiance = Vec3d(kAlbedo) * Vec3d(intensity) * (at.y / (r2 * std::sqrt(r2)) / std::numbers::pi);
  for (const auto& [light, name] : kStrategies)
    expectStill(t, t.render(scene, {.estimator = findingLightBy(light)}).film, radiance,
                fmt::format("point by {}", name));
}

void directionalLight(Trial& t) {
  const Vec3d direction(0.5, -1.2, 0.3);
  const Vec3f irradiance(3.0F, 2.0F, 1.0F);
  Scene scene = floorAlone().build();
  addDirectionalLight(scene, direction, irradiance);
  const double cosine = -glm::normalize(direction).y;
  for (const auto& [light, name] : kStrategies) {
    expectStill(t, t.render(scene, {.estimator = findingLightBy(light)}).film,
                Vec3d(kAlbedo) * Vec3d(irradiance) * (cosine / std::numbers::pi),
                fmt::format("directional by {}", name));
  }
}

/// From below the floor, and behind a blocker: nothing. A blocker beyond a point light shades nothing.
void deltaLightsAreShadowed(Trial& t) {
  const auto lit = [&](const SceneBuilder& builder) {
    Scene scene = builder.build();
    addPointLight(scene, {0.4, 1.1, -0.7}, Vec3f(1.0F));
    addDirectionalLight(scene, {-0.4, -1.1, 0.7}, Vec3f(1.0F));
    return t.render(scene, {}).film;
  };
  t.expectConstant(lit(floorAlone().ceiling({0.2, 0.55, -0.35}, 0.1, diffuse(Vec3f(0.0F)))), Vec3d(0.0), 0,
                   "behind a blocker");
  SceneBuilder below;
  below.floor({0.0, 0.0, 0.0}, 1.0, diffuse(kAlbedo)).camera(lookAt({-0.5, -0.8, 0.1}, Vec3d(0.0), 10.0));
  t.expectConstant(lit(below), Vec3d(0.0), 0, "from below");
  Scene beyond = floorAlone().ceiling({0.4, 1.2, -0.7}, 0.3, diffuse(Vec3f(0.0F))).build();
  addPointLight(beyond, {0.4, 1.1, -0.7}, Vec3f(1.0F));
  const double r2 = 0.4 * 0.4 + 1.1 * 1.1 + 0.7 * 0.7;
  expectStill(t, t.render(beyond, {}).film, Vec3d(kAlbedo) * (1.1 / (r2 * std::sqrt(r2)) / std::numbers::pi),
              "blocker beyond");
}

/// Two of them and an area light: chosen by power, found by every strategy.
void deltaAndAreaLights(Trial& t) {
  LitFloor lit = litFloor();
  const Vec3d at(-0.6, 0.9, 0.5);
  const Vec3d direction(0.5, -1.2, 0.3);
  addPointLight(lit.scene, at, {0.5F, 1.0F, 2.0F});
  addDirectionalLight(lit.scene, direction, {0.3F, 0.1F, 0.2F});
  const double r2 = glm::dot(at, at);
  const Vec3d irradiance = Vec3d(0.5, 1.0, 2.0) * (at.y / (r2 * std::sqrt(r2))) +
                           Vec3d(Vec3f(0.3F, 0.1F, 0.2F)) * -glm::normalize(direction).y;
  const Vec3d expected = lit.radiance + Vec3d(kAlbedo) * irradiance / std::numbers::pi;
  for (const auto& [light, name] : kStrategies) {
    const Film film =
        t.render(lit.scene, {.estimator = findingLightBy(light), .width = 64, .height = 64, .frames = 64})
            .film;
    t.expectMean(film, expected, 0.01, fmt::format("three kinds of light by {}", name));
  }
}

constexpr Check kDeltaChecks[] = {
    {"pointLight", pointLight},
    {"directionalLight", directionalLight},
    {"deltaLightsAreShadowed", deltaLightsAreShadowed},
    {"deltaAndAreaLights", deltaAndAreaLights},
};

} // namespace

std::span<const Check> deltaChecks() { return kDeltaChecks; }

} // namespace vkpt::test
