#include "scene/recentre.h"

#include <cmath>

#include <fmt/format.h>

namespace vkpt {

namespace {

/// ab == cd in exact arithmetic.
bool sameProducts(double a, double b, double c, double d) {
  const double ab = a * b;
  const double cd = c * d;
  return ab == cd && std::fma(a, b, -ab) == std::fma(c, d, -cd);
}

/// Exact for what the renderer gets, the float coordinates, unless the coordinates of one corner are 2^29
/// times those of another and their difference is rounded.
bool hasNoArea(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const Vec3d u = Vec3d(b) - Vec3d(a);
  const Vec3d v = Vec3d(c) - Vec3d(a);
  return sameProducts(u.x, v.y, u.y, v.x) && sameProducts(u.y, v.z, u.z, v.y) &&
         sameProducts(u.z, v.x, u.x, v.z);
}

} // namespace

Box3d recentre(Scene& scene, std::span<const Vec3d> world) {
  Box3d box;
  for (const Vec3d& p : world) {
    box.extend(p);
  }
  scene.origin = box.centre();
  scene.positions.reserve(world.size());
  for (const Vec3d& p : world) {
    scene.positions.emplace_back(p - scene.origin);
  }
  return box;
}

void dropDegenerate(Scene& scene, std::span<const MeshPart> parts, SceneReport& report) {
  std::vector<Triangle> kept;
  kept.reserve(scene.triangles.size());
  for (const MeshPart& part : parts) {
    std::size_t dropped = 0;
    std::size_t firstLine = 0;
    for (std::size_t i = 0; i < part.lines.size(); ++i) {
      const Triangle& t = scene.triangles[part.firstTriangle + i];
      const auto& p = scene.positions;
      if (!hasNoArea(p[t.vertex[0]], p[t.vertex[1]], p[t.vertex[2]])) {
        kept.push_back(t);
      } else if (dropped++ == 0) {
        firstLine = part.lines[i];
      }
    }
    if (dropped > 0) {
      report.droppedDegenerate += dropped;
      report.warnings.push_back(fmt::format("{}: {} triangle{} of zero area dropped{}",
                                            SourceLocation{part.name, firstLine}.text(), dropped,
                                            dropped == 1 ? "" : "s", dropped == 1 ? "" : ", the first here"));
    }
  }
  if (kept.empty()) {
    throw SceneError({parts.front().name}, fmt::format("no faces with an area (all {} triangles have none); "
                                                       "give at least one",
                                                       scene.triangles.size()));
  }
  scene.triangles = std::move(kept);
}

} // namespace vkpt
