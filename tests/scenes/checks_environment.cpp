// Environment maps: where each texel is, and the irradiance of surfaces under them.
#include "scenes/scene_extras.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

/// A small square plate about the origin with unit normal `n`, seen as one point.
Scene plateUnder(const EnvironmentMap& map, const Vec3d& n) {
  const Vec3d u = glm::normalize(glm::cross(n, Vec3d(0.3, 0.2, 1.0)));
  const Vec3d v = glm::cross(n, u);
  Scene scene = SceneBuilder()
                    .quad(-u - v, u - v, u + v, v - u, diffuse(kAlbedo))
                    .camera(lookAt(2.0 * n + 0.5 * u + 0.3 * v, Vec3d(0.0), kPointFov))
                    .build();
  scene.environment = map;
  return scene;
}

/// Pixels whose four corners look into one texel must have its radiance.
void environmentSeen(Trial& t) {
  constexpr int kEdge = 48;
  constexpr double kFov = 100.0;
  const EnvironmentMap map = environmentMap(8, 5, [](int column, int row) {
    return Vec3f(static_cast<float>(column + 1), static_cast<float>(row + 1), 1.0F);
  });
  for (const Vec3d& target : {Vec3d(0.3, -0.2, -1.0), Vec3d(-0.2, 0.6, 0.7), Vec3d(1.0, -0.9, 0.4)}) {
    Scene scene = plateUnder(map, kUp);
    scene.camera = lookAt({0.0, 50.0, 0.0}, Vec3d(0.0, 50.0, 0.0) + target, kFov);
    const Film film = t.render(scene, {.width = kEdge, .height = kEdge, .frames = 2}).film;
    const Vec3d forward = glm::normalize(target);
    const Vec3d right = glm::normalize(glm::cross(forward, kUp));
    const Vec3d down = glm::cross(forward, right);
    const double extent = std::tan(0.5 * kFov * std::numbers::pi / 180.0);
    const auto at = [&](int x, int y) {
      const auto along = [&](int i) { return extent * (2.0 * i / kEdge - 1.0); };
      return radianceFrom(map, forward + right * along(x) + down * along(y));
    };
    int seen = 0;
    int wrong = 0;
    for (int y = 0; y < kEdge; ++y) {
      for (int x = 0; x < kEdge; ++x) {
        const Vec3d texel = at(x, y);
        if (at(x + 1, y) != texel || at(x, y + 1) != texel || at(x + 1, y + 1) != texel)
          continue;
        ++seen;
        // Not so near the pole that a texel's corner lies within the pixel, nor where the plate is seen.
        wrong += film.at(x, y).mean != texel ? 1 : 0;
      }
    }
    t.expect(seen > kEdge * kEdge / 2 && wrong <= 4,
             fmt::format("{} of {} pixels show another texel", wrong, seen));
  }
}

/// A sky of one radiance is the constant background: radiance times albedo.
void constantEnvironment(Trial& t) {
  const Vec3f radiance(1.5F, 1.0F, 0.5F);
  const EnvironmentMap map = environmentMap(6, 3, [&](int, int) { return radiance; });
  const Scene scene = plateUnder(map, glm::normalize(Vec3d(0.4, 0.8, -0.3)));
  for (const auto& [light, name] : kStrategies) {
    const Film film =
        t.render(scene, {.estimator = findingLightBy(light), .width = 64, .height = 64, .frames = 64}).film;
    if (light == LightStrategy::Bsdf)
      t.expectConstant(film, Vec3d(kAlbedo) * Vec3d(radiance), 4, "constant sky");
    else
      t.expectMean(film, Vec3d(kAlbedo) * Vec3d(radiance), 0.01, fmt::format("constant sky by {}", name));
  }
}

/// Of a horizontal floor: each texel's cosine integrates to (sin^2 of its lower edge - that of its upper one)
/// / 2 times its width. Rows of 45 degrees, of very different radiance.
void unequalTexels(Trial& t) {
  const EnvironmentMap map = environmentMap(4, 4, [](int column, int row) {
    const float base = row == 0 ? 1.0F : 0.2F;
    return Vec3f(base, base * static_cast<float>(column + 1), row == 1 && column == 2 ? 5.0F : 0.1F);
  });
  Vec3d irradiance(0.0);
  for (int row = 0; row < 2; ++row) {
    const auto sin2 = [](int edge) { return 0.5 * edge; }; // of 0, 45 and 90 degrees
    for (int column = 0; column < 4; ++column) {
      irradiance += Vec3d(map.radiance[static_cast<std::size_t>(4 * row + column)]) *
                    (0.5 * std::numbers::pi * 0.5 * (sin2(row + 1) - sin2(row)));
    }
  }
  for (const auto& [light, name] : kStrategies) {
    const Film film = t.render(plateUnder(map, kUp),
                               {.estimator = findingLightBy(light), .width = 64, .height = 64, .frames = 128})
                          .film;
    t.expectMean(film, Vec3d(kAlbedo) * irradiance / std::numbers::pi, 0.012, fmt::format("sky by {}", name));
  }
}

/// One texel of 800 shines: light sampling alone finds it often.
void oneBrightTexel(Trial& t) {
  constexpr int kWidth = 40;
  constexpr int kHeight = 20;
  constexpr int kRow = 5;
  const EnvironmentMap map = environmentMap(kWidth, kHeight, [](int column, int row) {
    return Vec3f(column == 13 && row == kRow ? 100.0F : 0.0F);
  });
  const auto sine = [](int row) { return std::sin(std::numbers::pi * row / kHeight); };
  const double irradiance = 100.0 * 2.0 * std::numbers::pi / kWidth * 0.5 *
                            (sine(kRow + 1) * sine(kRow + 1) - sine(kRow) * sine(kRow));
  for (const EstimatorSettings& settings : {lightSampling(), misSampling()}) {
    const Film film =
        t.render(plateUnder(map, kUp), {.estimator = settings, .width = 32, .height = 32, .frames = 16}).film;
    t.expectMean(film, Vec3d(kAlbedo) * (irradiance / std::numbers::pi), 0.004);
  }
}

/// A gradient over a tilted plate, against quadrature.
void gradientSky(Trial& t) {
  const EnvironmentMap map = environmentMap(16, 8, [](int column, int row) {
    return Vec3f(0.1F * static_cast<float>(column), 0.2F * static_cast<float>(row),
                 0.05F * static_cast<float>(column * row));
  });
  const Vec3d n = glm::normalize(Vec3d(0.7, 0.5, -0.4));
  const Vec3d expected = Vec3d(kAlbedo) * skyIrradiance(map, n) / std::numbers::pi;
  for (const auto& [light, name] : kStrategies) {
    const Film film = t.render(plateUnder(map, n),
                               {.estimator = findingLightBy(light), .width = 64, .height = 64, .frames = 64})
                          .film;
    t.expectMean(film, expected, 0.012, fmt::format("gradient by {}", name));
  }
}

/// With an area light before it, which hides a part: its back is as black as its front is bright.
void environmentBehindLight(Trial& t) {
  const Vec3d light[4] = {{-0.5, 1.0, -0.4}, {0.7, 1.0, -0.4}, {0.7, 1.0, 0.6}, {-0.5, 1.0, 0.6}};
  const Vec3d radiance(2.0, 0.5, 1.0);
  const Vec3d sky(0.5, 1.0, 0.25);
  Scene scene = SceneBuilder()
                    .quad(light[0], light[1], light[2], light[3], emitter(Vec3f(radiance)))
                    .floor(Vec3d(0.0), 0.1, diffuse(kAlbedo))
                    .camera(lookAt({-0.8, 0.8, 0.1}, Vec3d(0.0), kPointFov))
                    .build();
  scene.environment = environmentMap(3, 2, [&](int, int row) { return row == 0 ? Vec3f(sky) : Vec3f(0.0F); });
  const double hidden =
      polygonIrradiance({light[0], light[1], light[2], light[3]}, Vec3d(0.0), kUp) / std::numbers::pi;
  const Vec3d expected = Vec3d(kAlbedo) * (sky + (radiance - sky) * hidden);
  for (const auto& [strategy, name] : kStrategies) {
    const Film film =
        t.render(scene, {.estimator = findingLightBy(strategy), .width = 64, .height = 64, .frames = 64})
            .film;
    t.expectMean(film, expected, 0.012, fmt::format("light before a sky by {}", name));
  }
}

constexpr Check kEnvironmentChecks[] = {
    {"environmentSeen", environmentSeen}, {"oneBrightTexel", oneBrightTexel},
    {"unequalTexels", unequalTexels},     {"constantEnvironment", constantEnvironment},
    {"gradientSky", gradientSky},         {"environmentBehindLight", environmentBehindLight},
};

} // namespace

std::span<const Check> environmentChecks() { return kEnvironmentChecks; }

} // namespace vkpt::test
