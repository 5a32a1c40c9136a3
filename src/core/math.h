#pragma once
// Vector types of the host. Names follow GLSL; lengths are in scene units, angles in radians unless said.

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/glm.hpp>

namespace vkpt {

using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;
using Vec2i = glm::ivec2;

inline bool isFinite(const Vec3d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline double maxComponent(const Vec3d& v) { return std::max({v.x, v.y, v.z}); }

/// Axis-aligned box; empty when any `lower` exceeds its `upper`.
template<class T>
struct Box {
  glm::vec<3, T> lower{std::numeric_limits<T>::max()};
  glm::vec<3, T> upper{std::numeric_limits<T>::lowest()};

  void extend(const glm::vec<3, T>& p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  void extend(const Box& b) {
    lower = glm::min(lower, b.lower);
    upper = glm::max(upper, b.upper);
  }
  [[nodiscard]] bool empty() const { return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z; }
  [[nodiscard]] glm::vec<3, T> centre() const { return (lower + upper) * T(0.5); }
  [[nodiscard]] glm::vec<3, T> extent() const { return upper - lower; }
  /// Half the surface area (the factor cancels in every use of the surface area heuristic).
  [[nodiscard]] T halfArea() const {
    const auto e = extent();
    return e.x * e.y + e.y * e.z + e.z * e.x;
  }
};
using Box3f = Box<float>;
using Box3d = Box<double>;

} // namespace vkpt
