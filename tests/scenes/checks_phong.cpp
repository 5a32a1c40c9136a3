// Phong's lobe against its integral: seen in surroundings of radiance 1.
#include "scenes/scene_extras.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
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

constexpr Check kChecks[] = {
    {"phongHeadOn", phongHeadOn},
    {"phongInWhite", phongInWhite},
};

} // namespace

std::span<const Check> phongChecks() { return kChecks; }

} // namespace vkpt::test
