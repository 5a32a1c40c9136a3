#include "scenes/scene_extras.h"

#include <cmath>
#include <numbers>

namespace vkpt::test {

EstimatorSettings findingLightBy(LightStrategy light) {
  EstimatorSettings s;
  s.light = light;
  return s;
}

void addPointLight(Scene& scene, const Vec3d& position, const Vec3f& intensity) {
  scene.pointLights.push_back({{}, Vec3f(position - scene.origin), intensity});
}

void addDirectionalLight(Scene& scene, const Vec3d& direction, const Vec3f& irradiance) {
  scene.directionalLights.push_back({{}, Vec3f(glm::normalize(direction)), irradiance});
}

EnvironmentMap environmentMap(int width, int height,
                              const std::function<Vec3f(int column, int row)>& radiance) {
  EnvironmentMap map;
  map.width = width;
  map.height = height;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column)
      map.radiance.push_back(radiance(column, row));
  }
  return map;
}

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

Texture textureOf(int width, int height, const std::vector<Vec3f>& texels) {
  Texture t;
  t.width = width;
  t.height = height;
  t.texels = texels;
  return t;
}

void textureLastQuad(Scene& scene, const Texture& texture, const std::array<Vec2f, 4>& uv) {
  const auto first = static_cast<std::uint32_t>(scene.uvs.size());
  scene.uvs.insert(scene.uvs.end(), uv.begin(), uv.end());
  const auto index = static_cast<std::uint32_t>(scene.textures.size());
  scene.textures.push_back(texture);
  const std::size_t last = scene.triangles.size() - 1;
  scene.triangles[last - 1].uv = {first, first + 1, first + 2}; // SceneBuilder::quad()
  scene.triangles[last].uv = {first, first + 2, first + 3};
  for (const std::size_t t : {last - 1, last})
    scene.materials[scene.triangles[t].material].texture = index;
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

Scene variety() {
  Material tinted = glass(1.4F);
  tinted.absorption = {0.2F, 1.0F, 2.0F};
  Material backless = diffuse({0.3F, 0.7F, 0.4F});
  backless.twoSided = false;
  Scene scene =
      SceneBuilder()
          .box({-0.9, 0.05, -0.5}, {-0.2, 0.6, 0.2}, Facing::Outward, tinted)
          .box({0.0, 0.0, -0.9}, {0.4, 0.5, -0.5}, Facing::Outward, phong(Vec3f(0.3F), Vec3f(0.5F), 40.0F))
          .quad({-1.4, 0.0, -1.2}, {0.2, 0.0, -1.4}, {0.2, 1.4, -1.4}, {-1.4, 1.4, -1.2},
                mirror({0.9F, 0.8F, 0.7F}))
          .quad({0.4, 0.0, -1.2}, {1.2, 0.0, -0.6}, {1.2, 0.9, -0.6}, {0.4, 0.9, -1.2},
                metal({0.2F, 0.9F, 1.1F}, {3.9F, 2.5F, 2.2F}))
          .quad({0.5, 0.0, 0.3}, {1.0, 0.0, 0.1}, {1.0, 0.5, 0.1}, {0.5, 0.5, 0.3}, backless)
          .ceiling({0.3, 1.5, 0.2}, 0.3, emitter({3.0F, 2.5F, 2.0F}))
          .floor({0.0, 0.0, 0.0}, 1.5, diffuse({0.8F, 0.7F, 0.6F}))
          .camera(lookAt({0.2, 1.3, 2.6}, {0.0, 0.3, -0.2}, 48.0))
          .build();
  textureLastQuad(scene, textureOf(2, 2, {{1.0F, 0.5F, 0.5F}, Vec3f(0.3F), Vec3f(0.4F), {0.5F, 0.6F, 1.0F}}),
                  {Vec2f(0.0F), {3.0F, 0.0F}, {3.0F, 3.0F}, {0.0F, 3.0F}});
  addPointLight(scene, {-1.2, 1.2, 1.0}, {0.5F, 0.6F, 0.9F});
  addDirectionalLight(scene, {-0.3, -1.0, -0.6}, {0.4F, 0.4F, 0.3F});
  scene.environment = environmentMap(8, 4, [](int column, int row) {
    return row == 1 && column == 5 ? Vec3f(2.0F, 1.6F, 1.0F)
                                   : Vec3f(0.1F, 0.2F, 0.3F + 0.05F * static_cast<float>(row));
  });
  return scene;
}

} // namespace vkpt::test
