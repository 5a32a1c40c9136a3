// Phong's lobe against its integral: seen in surroundings of radiance 1.
#include "selftest/case.h"
#include "selftest/scene_builder.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::selftest {
namespace {

/// ks' factor: (n + 2) / (2 pi) times the integral of cos^n(alpha) cos(theta) above the surface, alpha from
/// the mirror direction at `degrees`. Midpoint rule in alpha's own frame, fine where the lobe is narrow.
double lobeAlbedo(double n, double degrees) {
  constexpr int kSteps = 2000;
  constexpr int kTurns = 360;
  const double tilt = degrees * std::numbers::pi / 180.0;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    // cos(alpha)^(n + 1) uniform in (0, 1): then cos^n sin d(alpha) is its step / (n + 1).
    const double cosA = std::pow((i + 0.5) / kSteps, 1.0 / (n + 1.0));
    const double sinA = std::sqrt(1.0 - cosA * cosA);
    for (int j = 0; j < kTurns; ++j) {
      const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kTurns;
      sum += std::max(cosA * std::cos(tilt) - sinA * std::cos(turn) * std::sin(tilt), 0.0);
    }
  }
  return (n + 2.0) / (n + 1.0) * sum / (double{kSteps} * kTurns);
}

Film plateInWhite(Trial& t, const Material& material, double degrees, std::uint64_t frames) {
  const double a = degrees * std::numbers::pi / 180.0;
  const Scene scene =
      SceneBuilder()
          .floor(Vec3d(0.0), 1.0, material)
          .camera(lookAt({2.0 * std::sin(a), 2.0 * std::cos(a), 0.0}, Vec3d(0.0), kPointFov, {0.0, 0.0, 1.0}))
          .background(Vec3f(1.0F))
          .build();
  return t.render(scene, {.estimator = bsdfSampling(), .width = 64, .height = 64, .frames = frames}).film;
}

void phongInWhite(Trial& t) {
  const Vec3f diffuse(0.3F, 0.1F, 0.2F);
  const Vec3f specular(0.5F, 0.6F, 0.2F);
  for (const float n : {0.0F, 5.0F, 100.0F, 10000.0F}) {
    for (const double degrees : {0.0, 70.0}) {
      const Film film = plateInWhite(t, phong(diffuse, specular, n), degrees, degrees == 0.0 ? 16 : 48);
      const double lobe = lobeAlbedo(double{n}, degrees);
      t.expectMean(film, Vec3d(diffuse) + Vec3d(specular) * lobe, 0.01,
                   fmt::format("n = {} at {} degrees", n, degrees));
    }
  }
}

/// Head-on the lobe's integral is 1 for every exponent.
void phongHeadOn(Trial& t) {
  for (const float n : {1.0F, 20.0F, 1e6F}) {
    const Film film = plateInWhite(t, phong(Vec3f(0.0F), {0.9F, 0.5F, 0.1F}, n), 0.0, 16);
    t.expectMean(film, Vec3d(Vec3f(0.9F, 0.5F, 0.1F)), 0.01, fmt::format("n = {}", n));
  }
}

/// A degree from the plane: Phong, half of whose lobe lies below, silver, and a diffuse surface in the light
/// of a wall that it sees just as flat.
void grazing(Trial& t) {
  for (const float n : {5.0F, 100.0F}) {
    const Film film = plateInWhite(t, phong(Vec3f(0.0F), Vec3f(0.9F), n), 89.0, 96);
    t.expectMean(film, Vec3d(double{0.9F} * lobeAlbedo(double{n}, 89.0)), 0.02,
                 fmt::format("phong, n = {}", n));
  }
  const Vec3f eta(0.0552F, 0.0540F, 0.0420F); // silver: cases_d_smooth.cpp
  const Vec3f k(4.2800F, 3.4290F, 2.3500F);
  const Film silver = plateInWhite(t, metal(eta, k), 89.0, 4);
  const double cosine = std::cos(89.0 * std::numbers::pi / 180.0);
  for (int c = 0; c < 3; ++c) {
    const double exact = exactFresnelConductor(cosine, double{eta[c]}, double{k[c]});
    t.atMost("silver, off by", std::abs(silver.at(32, 32).mean[c] - exact), 2e-5);
  }
  const Scene scene =
      SceneBuilder()
          .floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.8F)))
          .quad({8.0, 0.0, -0.5}, {8.0, 0.0, 0.5}, {8.0, 0.2, 0.5}, {8.0, 0.2, -0.5}, emitter(Vec3f(50.0F)))
          .camera(lookAt({0.0, 2.0, 0.0}, Vec3d(0.0), kPointFov, {0.0, 0.0, 1.0}))
          .build();
  const double irradiance =
      50.0 * polygonIrradiance({{8.0, 0.0, -0.5}, {8.0, 0.0, 0.5}, {8.0, 0.2, 0.5}, {8.0, 0.2, -0.5}},
                               Vec3d(0.0), {0.0, 1.0, 0.0});
  const Film lit =
      t.render(scene, {.estimator = misSampling(), .width = 64, .height = 64, .frames = 64}).film;
  t.expectMean(lit, Vec3d(double{0.8F} / std::numbers::pi * irradiance), 0.01, "diffuse in flat light");
}

/// Surfaces that return more than they get: as they are written, not clamped.
void gain(Trial& t) {
  const auto lit = [&](const Material& material) { return plateInWhite(t, material, 0.0, 32); };
  t.expectConstant(lit(diffuse(Vec3f(1.3F, 0.4F, 0.5F))), Vec3d(Vec3f(1.3F, 0.4F, 0.5F)), 2, "albedo 1.3");
  t.expectMean(lit(phong(Vec3f(1.0F), Vec3f(1.0F), 20.0F)), Vec3d(2.0), 0.01, "kd + ks = 2");
}

constexpr Case kPhongCases[] = {
    {"d10-phong-head-on", "seen head-on Phong's lobe returns ks, for exponents to 1e6", phongHeadOn},
    {"d10-phong-in-white", "Phong's lobe against its integral, for angles and exponents", phongInWhite},
    {"d13-grazing", "Phong, silver and diffuse surfaces at 89 degrees", grazing},
    {"d14-gain", "albedos above 1, and kd + ks = 2, are taken as they are written", gain},
};

} // namespace

std::span<const Case> phongCases() { return kPhongCases; }

} // namespace vkpt::selftest
