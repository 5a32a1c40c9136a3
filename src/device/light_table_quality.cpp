#include "device/light_table_quality.h"

#include "device/effective_material.h"
#include "device/light_table.h"
#include "device/packed_light_node.h"
#include "shared/structs.h"

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

using shared::kAliasUnits;
using shared::kLightGridEdge;
using shared::kLightGridSides;

/// What one light sample brings to a place, unoccluded: its mean, and its second moment by the tables and by
/// the tree alone.
struct Moments {
  double mean = 0.0;
  double tables = 0.0;
  double tree = 0.0;
};

class Judge {
public:
  Judge(const PackedScene& scene, const CubeGrid& grid, const LightGridFunctions& functions)
      : m_scene(scene), m_grid(grid), m_functions(functions) {}
  Moments at(const Vec3f& p, const Vec3f& n) {
    m_p = p;
    m_n = n;
    const Vec3f q = (p - m_grid.lower) * m_grid.cubesPerMetre;
    const auto along = [&](int axis) {
      return static_cast<std::uint32_t>(std::clamp(q[axis], 0.0F, kLightGridEdge - 0.5F));
    };
    const std::uint32_t cube = shared::guideCube(along(0), along(1), along(2), kLightGridEdge);
    m_table = m_scene.lightGrid[cube * kLightGridSides + m_functions.side(n)];
    Moments sum;
    add(0, 1.0, 0.0, sum);
    return sum;
  }

private:
  /// What lies below a node that the tree reaches with one probability and the tables with another, 0 above
  /// their cut.
  void add(std::uint32_t i, double byTree, double byTables, Moments& sum) {
    const PackedLightNode node = lightNodeOf(m_scene, i);
    if (node.bin > 0)
      byTables = (m_scene.lightGrid[m_table + node.bin - 1] & 65535U) / static_cast<double>(kAliasUnits);
    if (node.leaf) {
      const double brings = broughtBy(node);
      sum.mean += brings;
      sum.tree += brings * brings / byTree;
      sum.tables += brings * brings / byTables;
      return;
    }
    const double first = static_cast<double>(m_functions.importance(node.below, m_p, m_n));
    const double second = static_cast<double>(m_functions.importance(node.below + 1, m_p, m_n));
    const double share =
        std::clamp(first + second > 0.0 ? first / (first + second) : 0.5, 0x1p-24, 1.0 - 0x1p-24);
    add(node.below, byTree * share, byTables * share, sum);
    add(node.below + 1, byTree * (1.0 - share), byTables * (1.0 - share), sum);
  }

  /// As if the light were in the middle of its bounds: these may lie in front of a surface that it turns its
  /// back on.
  [[nodiscard]] double broughtBy(const PackedLightNode& light) const {
    const Vec3d there = light.centre - Vec3d(m_p);
    const double r2 = glm::dot(there, there);
    if (r2 == 0.0)
      return 0.0;
    const double atLight =
        light.cosSpread <= -1.0 ? 1.0 : std::max(-glm::dot(light.axis, there), 0.0) / std::sqrt(r2);
    const double atSurface = std::max(glm::dot(Vec3d(m_n), there), 0.0) / std::sqrt(r2);
    return light.power * atLight * atSurface / r2;
  }

  const PackedScene& m_scene;
  const CubeGrid& m_grid;
  const LightGridFunctions& m_functions;
  Vec3f m_p{0.0F};
  Vec3f m_n{0.0F};
  std::uint32_t m_table = 0;
};

struct Place {
  Vec3f p, n;
};

/// Spread over the surfaces, on either side in turn.
class Places {
public:
  explicit Places(const Scene& scene) : m_scene(scene) {
    for (const Triangle& t : scene.triangles) {
      const bool none = isNothing(scene.materials[t.material]);
      m_areas.push_back(m_areas.back() + (none ? 0.0 : triangleArea(scene, t)));
    }
  }
  [[nodiscard]] bool empty() const { return !(m_areas.back() > 0.0); }
  [[nodiscard]] Place at(std::uint32_t i, std::uint32_t count) const {
    const auto spread = [i](double step) { return std::fmod(0.5 + i * step, 1.0); }; // Roberts's sequence
    const double along = (i + 0.5) / count * m_areas.back();
    const auto above = std::ranges::upper_bound(m_areas, along); // not past the end: along is less than all
    const Triangle& t = m_scene.triangles[static_cast<std::size_t>(above - m_areas.begin() - 1)];
    const Vec3d a(m_scene.positions[t.vertex[0]]);
    const Vec3d u = Vec3d(m_scene.positions[t.vertex[1]]) - a;
    const Vec3d v = Vec3d(m_scene.positions[t.vertex[2]]) - a;
    const double root = std::sqrt(spread(0.7548776662466927));
    const double other = spread(0.5698402909980532);
    return {Vec3f(a + u * (root * (1.0 - other)) + v * (root * other)),
            Vec3f(glm::normalize(glm::cross(u, v)) * (i % 2 == 0 ? 1.0 : -1.0))};
  }

private:
  const Scene& m_scene;
  std::vector<double> m_areas{0.0}; ///< summed up to each triangle
};

} // namespace

bool tablesChooseAsWell(const PackedScene& scene, const Scene& source, const CubeGrid& grid,
                        const LightGridFunctions& functions) {
  constexpr double kAsWell = 1.1;
  constexpr std::uint32_t kVisits = 1U << 19U; // of lights, in all places together
  const std::uint32_t count = std::clamp(kVisits / std::max(scene.lightChoice.count, 1U), 16U, 512U);
  const Places places(source);
  Judge judge(scene, grid, functions);
  double logarithms = 0.0;
  double weights = 0.0;
  for (std::uint32_t i = 0; i < count && !places.empty(); ++i) {
    const Place place = places.at(i, count);
    const Moments m = judge.at(place.p, place.n);
    if (m.mean > 0.0) {
      logarithms += m.mean * std::log(m.tables / m.tree);
      weights += m.mean;
    }
  }
  return logarithms <= weights * std::log(kAsWell);
}

} // namespace vkpt
