// The proof. Take triangles whose every edge is an edge of an even number of them: crossing their surface is
// then the only way to change the parity of how often a ray to infinity meets them, and far away that is 0.
// Where it is 1, the surface closes off all that is seen. Neither the orientation of triangles nor their
// meeting one another elsewhere matters. Triangles share a corner where its coordinates are the same numbers.

#include "device/enclosure.h"

#include "device/effective_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

namespace vkpt {
namespace {

using Corners = std::array<Vec3d, 3>; ///< from the camera

/// Counts what a ray from the origin of the corners meets; says so where rounding could decide.
class Crossings {
public:
  explicit Crossings(const Vec3d& direction) : m_direction(direction) {}

  void add(const Corners& t) {
    const std::array<int, 3> sides{side(m_direction, t[0], t[1]), side(m_direction, t[1], t[2]),
                                   side(m_direction, t[2], t[0])};
    const auto [least, most] = std::ranges::minmax(sides);
    if (least < 0 && most > 0)
      return; // passes by
    const int volume = side(t[0], t[1], t[2]);
    if (std::ranges::count(sides, 0) > 0 || volume == 0)
      m_sure = false;
    else if (volume == sides[0])
      ++m_count; // before the eye, not behind it
  }
  [[nodiscard]] bool sure() const { return m_sure; }
  [[nodiscard]] std::size_t count() const { return m_count; }

private:
  /// On which side of the plane through the origin, b and c lies a: 1 or -1; 0 where rounding could decide.
  static int side(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double volume = glm::dot(a, glm::cross(b, c));
    const double rounding = 1e-13 * glm::length(a) * glm::length(b) * glm::length(c);
    return std::abs(volume) <= rounding ? 0 : (volume > 0.0 ? 1 : -1);
  }

  Vec3d m_direction;
  std::size_t m_count = 0;
  bool m_sure = true;
};

/// No axis, no diagonal.
constexpr std::array<Vec3d, 6> kDirections{Vec3d(0.5377, 0.3188, 0.7805),   Vec3d(-0.6112, 0.7408, 0.2789),
                                           Vec3d(0.2371, -0.8839, 0.4032),  Vec3d(-0.4419, -0.5263, -0.7264),
                                           Vec3d(0.8117, -0.1493, -0.5647), Vec3d(-0.1931, 0.4571, -0.8682)};

class Mesh {
public:
  explicit Mesh(const Scene& scene) : m_scene(scene), m_eye(Vec3f(scene.camera.eye - scene.origin)) {
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
      if (!transmits(scene.materials[scene.triangles[i].material]))
        m_opaque.push_back(i);
    }
  }

  /// Whether a ray meets nothing at all: then nothing is closed.
  [[nodiscard]] bool hasWayOut() const {
    return std::ranges::any_of(kDirections, [this](const Vec3d& d) {
      const Crossings crossings = crossingsOf(d, m_opaque);
      return crossings.sure() && crossings.count() == 0;
    });
  }

  /// A triangle of a closed mesh about the eye.
  [[nodiscard]] std::optional<std::uint32_t> closedAbout() {
    joinAtEdges();
    for (auto first = m_opaque.begin(); first != m_opaque.end();) {
      const auto last =
          std::find_if(first, m_opaque.end(), [&](std::uint32_t t) { return root(t) != root(*first); });
      const std::span<const std::uint32_t> part(first, last);
      if (!m_open[root(*first)] && isAbout(part))
        return *first;
      first = last;
    }
    return std::nullopt;
  }

private:
  struct Edge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t triangle;
    [[nodiscard]] auto ends() const { return std::pair(from, to); }
  };

  [[nodiscard]] Corners cornersOf(std::uint32_t triangle) const {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = Vec3d(m_scene.positions[m_scene.triangles[triangle].vertex[i]]) - m_eye;
    return corners;
  }

  [[nodiscard]] Crossings crossingsOf(const Vec3d& direction,
                                      std::span<const std::uint32_t> triangles) const {
    Crossings crossings(direction);
    for (const std::uint32_t t : triangles)
      crossings.add(cornersOf(t));
    return crossings;
  }

  [[nodiscard]] bool isAbout(std::span<const std::uint32_t> triangles) const {
    for (const Vec3d& d : kDirections) {
      const Crossings crossings = crossingsOf(d, triangles);
      if (crossings.sure())
        return crossings.count() % 2 == 1;
    }
    return false;
  }

  /// For each position the first one with the same coordinates.
  [[nodiscard]] std::vector<std::uint32_t> welded() const {
    const auto& p = m_scene.positions;
    std::vector<std::uint32_t> order(p.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&p](std::uint32_t i) { return std::tuple(p[i].x, p[i].y, p[i].z); };
    std::ranges::sort(order, {}, key);
    std::vector<std::uint32_t> same(p.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      same[order[i]] = i > 0 && key(order[i - 1]) == key(order[i]) ? same[order[i - 1]] : order[i];
    return same;
  }

  [[nodiscard]] std::vector<Edge> edges() const {
    const std::vector<std::uint32_t> corner = welded();
    std::vector<Edge> all;
    all.reserve(3 * m_opaque.size());
    for (const std::uint32_t t : m_opaque) {
      const auto& v = m_scene.triangles[t].vertex;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [from, to] = std::minmax(corner[v[i]], corner[v[(i + 1) % 3]]);
        all.push_back({from, to, t});
      }
    }
    std::ranges::sort(all, {}, &Edge::ends);
    return all;
  }

  [[nodiscard]] std::uint32_t root(std::uint32_t triangle) {
    while (m_parent[triangle] != triangle)
      triangle = m_parent[triangle] = m_parent[m_parent[triangle]];
    return triangle;
  }

  /// Parts that hang together by edges, `m_opaque` in their order, and which of them have an edge of an odd
  /// number of triangles.
  void joinAtEdges() {
    m_parent.resize(m_scene.triangles.size());
    std::iota(m_parent.begin(), m_parent.end(), 0U);
    m_open.assign(m_scene.triangles.size(), false);
    const std::vector<Edge> all = edges();
    std::vector<std::uint32_t> odd;
    for (auto first = all.begin(); first != all.end();) {
      const auto last =
          std::find_if(first, all.end(), [&](const Edge& e) { return e.ends() != first->ends(); });
      for (auto e = first + 1; e != last; ++e)
        m_parent[root(e->triangle)] = root(first->triangle);
      if ((last - first) % 2 == 1)
        odd.push_back(first->triangle);
      first = last;
    }
    for (const std::uint32_t triangle : odd)
      m_open[root(triangle)] = true;
    std::ranges::stable_sort(m_opaque, {}, [this](std::uint32_t t) { return root(t); });
  }

  const Scene& m_scene;
  Vec3d m_eye; ///< as the device rounds it
  std::vector<std::uint32_t> m_opaque;
  std::vector<std::uint32_t> m_parent; ///< by triangle
  std::vector<bool> m_open;            ///< by root
};

} // namespace

std::optional<std::uint32_t> enclosingMaterial(const Scene& scene) {
  Mesh mesh(scene);
  if (mesh.hasWayOut())
    return std::nullopt;
  if (const auto triangle = mesh.closedAbout())
    return scene.triangles[*triangle].material;
  return std::nullopt;
}

} // namespace vkpt
