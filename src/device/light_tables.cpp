#include "device/light_tables.h"

#include "accel/workers.h"
#include "device/alias_bins.h"
#include "device/effective_material.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vkpt {
namespace {

using shared::kAnySide;
using shared::kLightGridCubes;
using shared::kLightGridEdge;

/// The surfaces of a cube that face one side, as a plane.
struct Facing {
  Vec3d normal{0.0};   ///< summed over the triangles, weighted by area
  double offset = 0.0; ///< along each triangle's normal, the same
  double area = 0.0;
};
using Cube = std::array<Facing, kAnySide>;

/// visit(number) for every cube that a triangle's plane cuts within the triangle's box.
template<class Visit>
void eachCubeOf(const CubeGrid& grid, const std::array<Vec3d, 3>& v, const Vec3d& normal,
                const Visit& visit) {
  const double scale = static_cast<double>(grid.cubesPerMetre);
  constexpr double kHalf = 0.51; // of a cube and what rounding may add
  Box3d box;
  for (const Vec3d& p : v)
    box.extend((p - Vec3d(grid.lower)) * scale);
  const auto cubeAt = [&](double q) {
    return static_cast<std::uint32_t>(std::clamp(std::floor(q), 0.0, kLightGridEdge - 1.0));
  };
  const double reach = kHalf * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
  const double plane = glm::dot(normal, (v[0] - Vec3d(grid.lower)) * scale);
  for (std::uint32_t z = cubeAt(box.lower.z - 0.01); z <= cubeAt(box.upper.z + 0.01); ++z)
    for (std::uint32_t y = cubeAt(box.lower.y - 0.01); y <= cubeAt(box.upper.y + 0.01); ++y)
      for (std::uint32_t x = cubeAt(box.lower.x - 0.01); x <= cubeAt(box.upper.x + 0.01); ++x) {
        const Vec3d centre = Vec3d(x, y, z) + 0.5;
        if (std::abs(glm::dot(normal, centre) - plane) <= reach)
          visit(shared::guideCube(x, y, z, kLightGridEdge));
      }
}

std::vector<Cube> surfacesIn(const CubeGrid& grid, const Scene& scene, const LightGridFunctions& functions) {
  std::vector<Cube> cubes(kLightGridCubes);
  for (const Triangle& t : scene.triangles) {
    if (isNothing(scene.materials[t.material]))
      continue;
    std::array<Vec3d, 3> v;
    for (std::size_t i = 0; i < 3; ++i)
      v[i] = Vec3d(scene.positions[t.vertex[i]]);
    const Vec3d across = glm::cross(v[1] - v[0], v[2] - v[0]);
    const double area = glm::length(across);
    if (!(area > 0.0))
      continue;
    const Vec3d front = across / area;
    const std::array<std::uint32_t, 2> sides{functions.side(Vec3f(front)), functions.side(Vec3f(-front))};
    eachCubeOf(grid, v, front, [&](std::uint32_t cube) {
      for (const std::size_t back : {0U, 1U}) {
        const Vec3d normal = back != 0 ? -across : across; // times the area
        Facing& f = cubes[cube][sides[back]];
        f.normal += normal;
        f.offset += glm::dot(normal, v[0]);
        f.area += area;
      }
    });
  }
  return cubes;
}

/// What the nodes bring to some places, for a normal.
BinWeights weightsAt(const LightGridFunctions& functions, std::span<const std::uint32_t> cut,
                     std::size_t bins, std::span<const Vec3d> places, const Vec3d& normal) {
  BinWeights weights(bins);
  for (std::size_t bin = 0; bin < cut.size(); ++bin)
    for (const Vec3d& p : places)
      weights[bin] += static_cast<double>(functions.importance(cut[bin], Vec3f(p), Vec3f(normal)));
  return weights;
}

SideTables tablesOf(const LightGridFunctions& functions, std::span<const std::uint32_t> cut, std::size_t bins,
                    const Cube& cube, const Vec3d& middle, double edge) {
  static const std::array<Vec3d, 4> kCorners{
      {Vec3d(1.0, 1.0, 1.0), {1.0, -1.0, -1.0}, {-1.0, 1.0, -1.0}, {-1.0, -1.0, 1.0}}};
  SideTables tables;
  std::array<Vec3d, 4> places;
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = middle + kCorners[i] * (0.25 * edge);
  bool any = false;
  for (std::uint32_t side = 0; side < kAnySide; ++side) {
    const Facing& f = cube[side];
    if (f.area == 0.0)
      continue;
    any = true;
    const Vec3d normal = glm::normalize(f.normal);
    const double offset = f.offset / glm::length(f.normal);
    std::array<Vec3d, 4> onPlane = places;
    for (Vec3d& p : onPlane)
      p -= normal * (glm::dot(normal, p) - offset);
    appendLightTable(weightsAt(functions, cut, bins, onPlane, normal), cut.size(), tables[side]);
  }
  if (any)
    appendLightTable(weightsAt(functions, cut, bins, places, Vec3d(0.0)), cut.size(), tables[kAnySide]);
  return tables;
}

Vec3d middleOf(const CubeGrid& grid, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return Vec3d(grid.lower) + (Vec3d(x, y, z) + 0.5) / static_cast<double>(grid.cubesPerMetre);
}

} // namespace

void appendLightTable(BinWeights weights, std::size_t nodes, std::vector<std::uint32_t>& out) {
  // Of each node, whatever it may bring, so that no light is left out: bounds are bounds to rounding alone.
  constexpr double kLeastUnits = 2.0;
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t bin = 0; bin < nodes; ++bin)
    weights[bin] = sum > 0.0 ? weights[bin] + sum * (kLeastUnits / shared::kAliasUnits) : 1.0;
  appendAliasBins(weights, out);
}

std::vector<SideTables> lightTables(const CubeGrid& grid, const Scene& scene,
                                    std::span<const std::uint32_t> cut, std::size_t bins,
                                    const std::function<LightGridFunctions()>& functions, unsigned threads) {
  const std::vector<Cube> cubes = surfacesIn(grid, scene, functions());
  std::vector<SideTables> tables(kLightGridCubes);
  accel::Workers(threads).forEach(kLightGridEdge, [&](std::size_t layer) {
    const LightGridFunctions own = functions();
    const auto z = static_cast<std::uint32_t>(layer);
    for (std::uint32_t y = 0; y < kLightGridEdge; ++y)
      for (std::uint32_t x = 0; x < kLightGridEdge; ++x) {
        const std::uint32_t cube = shared::guideCube(x, y, z, kLightGridEdge);
        tables[cube] = tablesOf(own, cut, bins, cubes[cube], middleOf(grid, x, y, z),
                                1.0 / static_cast<double>(grid.cubesPerMetre));
      }
  });
  return tables;
}

} // namespace vkpt
