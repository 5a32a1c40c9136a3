#include "scene/polygon.h"

#include <cmath>
#include <numeric>

namespace vkpt {

namespace {

using Vec2d = glm::dvec2;

/// Newell's normal: twice the area vector, also of concave and slightly bent faces.
Vec3d areaVector(std::span<const Vec3d> corners) {
  Vec3d sum(0.0);
  for (std::size_t i = 2; i < corners.size(); ++i) {
    sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  return sum;
}

/// Drops the normal's largest coordinate; counterclockwise faces stay counterclockwise.
std::vector<Vec2d> project(std::span<const Vec3d> corners, const Vec3d& normal) {
  const Vec3d size = glm::abs(normal);
  const int dropped = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
  int u = (dropped + 1) % 3;
  int v = (dropped + 2) % 3;
  if (normal[dropped] < 0.0) {
    std::swap(u, v);
  }
  std::vector<Vec2d> flat;
  flat.reserve(corners.size());
  for (const Vec3d& p : corners) {
    flat.emplace_back(p[u] - corners[0][u], p[v] - corners[0][v]);
  }
  return flat;
}

double signedArea(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool contains(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& p) {
  return signedArea(a, b, p) >= 0.0 && signedArea(b, c, p) >= 0.0 && signedArea(c, a, p) >= 0.0;
}

/// Ear clipping. It looks for ears from corner 1 on, so a convex face gives a fan about corner 0.
class EarClipper {
public:
  explicit EarClipper(std::vector<Vec2d> points) : m_points(std::move(points)), m_ring(m_points.size()) {
    std::iota(m_ring.begin(), m_ring.end(), 0U);
  }

  /// False when the outline crosses itself; then the triangles are of no use.
  bool clip(std::vector<std::array<std::uint32_t, 3>>& triangles) {
    while (m_ring.size() > 3) {
      std::size_t i = 0;
      while (i < m_ring.size() && !isEar(1 + i)) {
        ++i;
      }
      if (i == m_ring.size()) {
        return false;
      }
      triangles.push_back(around(1 + i));
      m_ring.erase(m_ring.begin() + static_cast<std::ptrdiff_t>((1 + i) % m_ring.size()));
    }
    triangles.push_back({m_ring[0], m_ring[1], m_ring[2]});
    return areaOf(triangles.back()) >= 0.0;
  }

private:
  [[nodiscard]] std::array<std::uint32_t, 3> around(std::size_t i) const {
    const std::size_t n = m_ring.size();
    return {m_ring[(i + n - 1) % n], m_ring[i % n], m_ring[(i + 1) % n]};
  }

  [[nodiscard]] double areaOf(const std::array<std::uint32_t, 3>& t) const {
    return signedArea(m_points[t[0]], m_points[t[1]], m_points[t[2]]);
  }

  [[nodiscard]] bool isEar(std::size_t i) const {
    const auto ear = around(i);
    if (!(areaOf(ear) > 0.0)) {
      return false;
    }
    const Vec2d& a = m_points[ear[0]];
    const Vec2d& b = m_points[ear[1]];
    const Vec2d& c = m_points[ear[2]];
    for (std::size_t j = 0; j < m_ring.size(); ++j) {
      const Vec2d& p = m_points[m_ring[j]];
      // Only corners that are not convex can be the first to stand inside an ear.
      if (p != a && p != b && p != c && areaOf(around(j)) <= 0.0 && contains(a, b, c, p)) {
        return false;
      }
    }
    return true;
  }

  std::vector<Vec2d> m_points;
  std::vector<std::uint32_t> m_ring;
};

void appendFan(std::size_t corners, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::size_t i = 2; i < corners; ++i) {
    triangles.push_back({0U, static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i)});
  }
}

bool fanIsExact(const std::vector<Vec2d>& points) {
  for (std::size_t i = 2; i < points.size(); ++i) {
    if (!(signedArea(points[0], points[i - 1], points[i]) > 0.0)) {
      return false;
    }
  }
  return true;
}

} // namespace

PolygonKind triangulate(std::span<const Vec3d> corners,
                        std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (corners.size() == 3) {
    appendFan(3, triangles);
    return PolygonKind::Simple;
  }
  const Vec3d normal = areaVector(corners);
  if (normal == Vec3d(0.0)) {
    appendFan(corners.size(), triangles);
    return PolygonKind::Crossed;
  }
  std::vector<Vec2d> points = project(corners, normal);
  if (fanIsExact(points)) {
    appendFan(corners.size(), triangles);
    return PolygonKind::Simple;
  }
  if (corners.size() > kMostConcaveCorners) {
    return PolygonKind::TooLarge;
  }
  const std::size_t before = triangles.size();
  if (!EarClipper(std::move(points)).clip(triangles)) {
    triangles.resize(before);
    appendFan(corners.size(), triangles);
    return PolygonKind::Crossed;
  }
  return PolygonKind::Simple;
}

} // namespace vkpt
