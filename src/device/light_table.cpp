#include "device/light_table.h"

#include <numeric>

namespace vkpt {

double triangleArea(const Scene& scene, const Triangle& t) {
  const Vec3d a = scene.positions[t.vertex[0]];
  const Vec3d b = scene.positions[t.vertex[1]];
  const Vec3d c = scene.positions[t.vertex[2]];
  return 0.5 * glm::length(glm::cross(b - a, c - a));
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

LightTable makeLightTable(const Scene& scene) {
  LightTable table;
  table.triangles = emissiveTriangles(scene);
  for (const std::uint32_t i : table.triangles) {
    const Triangle& t = scene.triangles[i];
    const Vec3d e = scene.materials[t.material].emission;
    table.probabilities.push_back(triangleArea(scene, t) * (e.x + e.y + e.z));
  }
  table.rows = makeAliasTable(table.probabilities);
  const double total = std::accumulate(table.probabilities.begin(), table.probabilities.end(), 0.0);
  for (double& p : table.probabilities)
    p /= total;
  return table;
}

} // namespace vkpt
