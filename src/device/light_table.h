#pragma once
// The lights that light sampling knows, and the table by which one is chosen in proportion to its power.

#include "scene/scene.h"

#include <span>
#include <vector>

namespace vkpt {

/// Triangles whose material emits and whose area is above 0, in input order.
std::vector<std::uint32_t> emissiveTriangles(const Scene& scene);

/// Whether there is an environment map that is not black.
bool hasEnvironment(const Scene& scene);

/// About all vertices.
Box3d sceneBox(const Scene& scene);

double triangleArea(const Scene& scene, const Triangle& triangle);

/// Solid angle of one texel in each row of a map in latitude and longitude, sr.
std::vector<double> texelSolidAngles(int width, int height);

struct AliasRow {
  double threshold;    ///< keep this row when a uniform number is below
  std::uint32_t alias; ///< else take this one
};
/// Walker's alias table for weights of which at least one is above 0: Vose 1991, "A linear algorithm for
/// generating random numbers with a given distribution".
std::vector<AliasRow> makeAliasTable(std::span<const double> weights);

struct LightSource {
  enum class Kind { Triangle, Point, Directional, Environment };
  Kind kind = Kind::Triangle;
  std::uint32_t index = 0;  ///< input triangle, or index into the scene's list
  double probability = 0.0; ///< with which it is chosen: in proportion to its power
};

struct LightTable {
  std::vector<LightSource> lights;
  std::vector<AliasRow> rows; ///< one for each light
  double totalPower = 0.0;    ///< in units of pi, summed over the channels
  [[nodiscard]] double environmentProbability() const;
};
/// Lights that can be hit are in it unless the strategy is to find them by BSDF sampling alone; what shines
/// from outside, unless the scene is closed about the camera.
LightTable makeLightTable(const Scene& scene, LightStrategy strategy);

} // namespace vkpt
