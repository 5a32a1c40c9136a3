#pragma once
// Emissive triangles, and the table by which one is chosen in proportion to its power.

#include "scene/scene.h"

#include <span>
#include <vector>

namespace vkpt {

/// Triangles whose material emits and whose area is above 0, in input order.
std::vector<std::uint32_t> emissiveTriangles(const Scene& scene);

double triangleArea(const Scene& scene, const Triangle& triangle);

struct AliasRow {
  double threshold;    ///< keep this row when a uniform number is below
  std::uint32_t alias; ///< else take this one
};
/// Walker's alias table for weights of which at least one is above 0: Vose 1991, "A linear algorithm for
/// generating random numbers with a given distribution".
std::vector<AliasRow> makeAliasTable(std::span<const double> weights);

struct LightTable {
  std::vector<std::uint32_t> triangles; ///< input triangle of each light
  std::vector<double> probabilities;    ///< in proportion to area times the sum of the radiance's channels
  std::vector<AliasRow> rows;
};
LightTable makeLightTable(const Scene& scene);

} // namespace vkpt
