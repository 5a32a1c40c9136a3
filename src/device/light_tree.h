#pragma once
// A binary tree over the lights, by which light sampling chooses those that matter where it stands: Conty
// Estevez and Kulla 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting", PACMCGIT 1(2).

#include "device/estimator_settings.h"
#include "device/light_table.h"

#include <cstdint>
#include <vector>

namespace vkpt {

/// What a node knows of the lights below it. Directions that a light sends nothing in lie more than 90
/// degrees from those of the cone.
struct LightBounds {
  Box3d box;
  Vec3d axis{0.0, 0.0, 1.0}; ///< unit
  double cosSpread = 1.0;    ///< of the cone's half angle; -1: lights shine in all directions
  double power = 0.0;        ///< share of all power
};

/// Bounds of both.
LightBounds unite(const LightBounds& a, const LightBounds& b);

struct LightTreeNode {
  LightBounds bounds;
  std::uint32_t below = 0;  ///< the first of two children that stand side by side; of a leaf the light
  std::uint32_t parent = 0; ///< the root's is itself
  bool leaf = false;
};

/// Siblings are 2 k and 2 k + 1; node 0 is the root, node 1 means nothing.
struct LightTree {
  std::vector<LightTreeNode> nodes;
  std::vector<std::uint32_t> leafOfLight;
  double smallestRadius = 0.0; ///< below it a node counts as no smaller: a millionth of the scene's size
};

/// Over the lights of the table, in its order; at least one. Splits by the surface area orientation
/// heuristic, no leaf deeper than `shared::kMaxLightTreeDepth`. What shines from infinitely far has the
/// sphere about the scene for its place.
LightTree makeLightTree(const Scene& scene, const LightTable& table);

/// Whether the settings have lights chosen by the tree: `LightSelection::Auto` for several that don't all lie
/// in one small place.
bool choosesByTree(const Scene& scene, const EstimatorSettings& settings, const LightTable& table);

} // namespace vkpt
