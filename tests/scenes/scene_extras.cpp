#include "scenes/scene_extras.h"

#include <cmath>
#include <numbers>

namespace vkpt::test {

Vec3d radianceFrom(const EnvironmentMap& map, const Vec3d& direction) {
  const Vec3d d = glm::normalize(direction);
  const double theta = std::acos(std::clamp(d.y, -1.0, 1.0));
  const double phi = std::atan2(d.x, -d.z); // 0 in -z, the middle of the map
  const int row = std::min(static_cast<int>(theta / std::numbers::pi * map.height), map.height - 1);
  const double turn = phi / (2.0 * std::numbers::pi) + 0.5;
  const int column = std::min(static_cast<int>(turn * map.width), map.width - 1);
  return map.radiance[static_cast<std::size_t>(row * map.width + column)];
}

Vec3d skyIrradiance(const EnvironmentMap& map, const Vec3d& n) {
  constexpr int kCells = 720;
  constexpr double kStep = std::numbers::pi / kCells;
  Vec3d irradiance(0.0);
  for (int i = 0; i < kCells; ++i) {
    const double theta = (i + 0.5) * kStep;
    for (int j = 0; j < 2 * kCells; ++j) {
      const double phi = (j + 0.5) * kStep - std::numbers::pi;
      const Vec3d d(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi));
      const double cosine = glm::dot(n, d);
      if (cosine > 0.0)
        irradiance += radianceFrom(map, d) * (cosine * std::sin(theta) * kStep * kStep);
    }
  }
  return irradiance;
}

Film renderAt(Trial& t, const Scene& scene, const EstimatorSettings& estimator, std::uint64_t frames) {
  return t.render(scene, {.estimator = estimator, .width = 64, .height = 64, .frames = frames}).film;
}

Scene glowingRoom() {
  return SceneBuilder()
      .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward,
           diffuse(Vec3f(0.99F), Vec3f(3.0F, 2.0F, 1.0F)))
      .camera(lookAt({0.0, 0.0, 0.9}, Vec3d(0.0), 80.0))
      .build();
}

Scene furnaceWithSolids(const Vec3f& albedo, const Vec3f& emission, const Camera& camera) {
  return SceneBuilder()
      .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse(albedo, emission))
      .box({-0.7, -0.9, -0.5}, {-0.1, -0.2, 0.1}, Facing::Outward, mirror(Vec3f(1.0F)))
      .box({0.1, -0.9, -0.3}, {0.7, 0.1, 0.2}, Facing::Outward, glass(1.5F))
      .camera(camera)
      .build();
}

Film columns(const Film& film, int first, int count) {
  Film part;
  part.width = count;
  part.height = film.height;
  for (int y = 0; y < film.height; ++y) {
    for (int x = first; x < first + count; ++x)
      part.pixels.push_back(film.at(x, y));
  }
  return part;
}

Vec3d sampleVariance(const Film& film) {
  Vec3d sum(0.0);
  for (const PixelMoments& p : film.pixels)
    sum += p.m2 / static_cast<double>(p.count - 1);
  return sum / static_cast<double>(film.pixels.size());
}

} // namespace vkpt::test
