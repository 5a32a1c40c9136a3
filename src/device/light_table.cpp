#include "device/light_table.h"

#include "device/enclosure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace vkpt {

Box3d sceneBox(const Scene& scene) {
  Box3d box;
  for (const Vec3f& p : scene.positions)
    box.extend(Vec3d(p));
  return box;
}

double triangleArea(const Scene& scene, const Triangle& t) {
  const Vec3d a = scene.positions[t.vertex[0]];
  const Vec3d b = scene.positions[t.vertex[1]];
  const Vec3d c = scene.positions[t.vertex[2]];
  return 0.5 * glm::length(glm::cross(b - a, c - a));
}

bool hasEnvironment(const Scene& scene) {
  return std::ranges::any_of(scene.environment.radiance, [](const Vec3f& L) { return L != Vec3f(0.0F); });
}

std::vector<std::uint32_t> emissiveTriangles(const Scene& scene) {
  std::vector<std::uint32_t> lights;
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const Triangle& t = scene.triangles[i];
    const Vec3f& e = scene.materials[t.material].emission;
    if ((e.x > 0.0F || e.y > 0.0F || e.z > 0.0F) && triangleArea(scene, t) > 0.0)
      lights.push_back(i);
  }
  return lights;
}

std::vector<AliasRow> makeAliasTable(std::span<const double> weights) {
  const std::size_t n = weights.size();
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<AliasRow> rows(n);
  std::vector<double> scaled(n);
  std::vector<std::uint32_t> small;
  std::vector<std::uint32_t> large;
  for (std::uint32_t i = 0; i < n; ++i) {
    scaled[i] = weights[i] / total * static_cast<double>(n);
    rows[i] = {1.0, i};
    (scaled[i] < 1.0 ? small : large).push_back(i);
  }
  while (!small.empty() && !large.empty()) {
    const std::uint32_t s = small.back();
    const std::uint32_t l = large.back();
    small.pop_back();
    rows[s] = {scaled[s], l};
    scaled[l] -= 1.0 - scaled[s];
    if (scaled[l] < 1.0) {
      large.pop_back();
      small.push_back(l);
    }
  }
  return rows;
}

std::vector<double> texelSolidAngles(int width, int height) {
  std::vector<double> angles(static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    const double upper = std::cos(std::numbers::pi * row / height);
    const double lower = std::cos(std::numbers::pi * (row + 1) / height);
    angles[static_cast<std::size_t>(row)] = 2.0 * std::numbers::pi / width * (upper - lower);
  }
  return angles;
}

namespace {

double channelSum(const Vec3f& v) { return static_cast<double>(v.x) + v.y + v.z; }

/// Of the sphere about the scene.
double squaredRadius(const Scene& scene) {
  const Box3d box = sceneBox(scene);
  const Vec3d half = 0.5 * box.extent();
  return box.empty() ? 1.0 : glm::dot(half, half);
}

double environmentFlux(const EnvironmentMap& map) {
  const auto angles = texelSolidAngles(map.width, map.height);
  double flux = 0.0;
  for (std::size_t i = 0; i < map.radiance.size(); ++i)
    flux += channelSum(map.radiance[i]) * angles[i / static_cast<std::size_t>(map.width)];
  return flux;
}

} // namespace

double LightTable::environmentProbability() const {
  for (const LightSource& light : lights) {
    if (light.kind == LightSource::Kind::Environment)
      return light.probability;
  }
  return 0.0;
}

LightTable makeLightTable(const Scene& scene, LightStrategy strategy) {
  using Kind = LightSource::Kind;
  LightTable table;
  std::vector<double> powers; // W / pi, of all channels
  const auto add = [&](Kind kind, std::uint32_t index, double power) {
    if (power > 0.0) {
      table.lights.push_back({kind, index, 0.0});
      powers.push_back(power);
    }
  };
  const bool comesFromOutside = hasEnvironment(scene) || !scene.directionalLights.empty();
  const bool open = comesFromOutside && !enclosingMaterial(scene);
  if (strategy != LightStrategy::Bsdf) {
    for (const std::uint32_t i : emissiveTriangles(scene)) {
      const Triangle& t = scene.triangles[i];
      add(Kind::Triangle, i, triangleArea(scene, t) * channelSum(scene.materials[t.material].emission));
    }
    if (open && hasEnvironment(scene))
      add(Kind::Environment, 0, squaredRadius(scene) * environmentFlux(scene.environment));
  }
  for (std::uint32_t i = 0; i < scene.pointLights.size(); ++i)
    add(Kind::Point, i, 4.0 * channelSum(scene.pointLights[i].intensity));
  for (std::uint32_t i = 0; open && i < scene.directionalLights.size(); ++i)
    add(Kind::Directional, i, squaredRadius(scene) * channelSum(scene.directionalLights[i].irradiance));
  if (powers.empty())
    return table;
  table.rows = makeAliasTable(powers);
  table.totalPower = std::accumulate(powers.begin(), powers.end(), 0.0);
  for (std::size_t i = 0; i < powers.size(); ++i)
    table.lights[i].probability = powers[i] / table.totalPower;
  return table;
}

} // namespace vkpt
