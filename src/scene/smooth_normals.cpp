#include "scene/smooth_normals.h"

#include <algorithm>
#include <cmath>

namespace vkpt {

namespace {

/// Corner normals this close to the geometric normal (a chord, for unit vectors) make a flat face.
constexpr double kFlat = 1e-6;

/// Squares of what float coordinates can differ by stay in the range of double, so the length needs no care.
Vec3d unitOrZero(const Vec3d& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : Vec3d(0.0);
}

Vec3d faceNormal(std::span<const Vec3d> positions, const Triangle& t) {
  const Vec3d& a = positions[t.vertex[0]];
  return unitOrZero(glm::cross(positions[t.vertex[1]] - a, positions[t.vertex[2]] - a));
}

double cornerAngle(std::span<const Vec3d> positions, const Triangle& t, std::size_t corner) {
  const Vec3d& p = positions[t.vertex[corner]];
  const Vec3d a = unitOrZero(positions[t.vertex[(corner + 1) % 3]] - p);
  const Vec3d b = unitOrZero(positions[t.vertex[(corner + 2) % 3]] - p);
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

bool wantsNormals(const Triangle& t, const Vec3d& geometric, std::span<const Vec3d> normals) {
  bool flat = true;
  for (const std::uint32_t v : t.vertex) {
    if (normals[v] == Vec3d(0.0)) {
      return false;
    }
    flat = flat && glm::length(normals[v] - geometric) <= kFlat;
  }
  return !flat;
}

} // namespace

std::vector<Vec3d> makeSmoothNormals(std::span<const Vec3d> positions, std::span<Triangle> triangles,
                                     std::size_t& count) {
  std::vector<Vec3d> normals(positions.size(), Vec3d(0.0));
  for (const Triangle& t : triangles) {
    const Vec3d n = faceNormal(positions, t);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      normals[t.vertex[corner]] += n * cornerAngle(positions, t, corner);
    }
  }
  // What is left of normals that cancel is rounding, and no direction.
  constexpr double kCancelled = 1e-9;
  for (Vec3d& n : normals) {
    n = glm::length(n) > kCancelled ? glm::normalize(n) : Vec3d(0.0);
  }
  std::vector<bool> used(positions.size(), false);
  for (Triangle& t : triangles) {
    if (wantsNormals(t, faceNormal(positions, t), normals)) {
      t.normal = t.vertex;
      for (const std::uint32_t v : t.vertex) {
        used[v] = true;
      }
    }
  }
  count = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
  return normals;
}

} // namespace vkpt
