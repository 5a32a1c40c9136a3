#pragma once
// Which lights matter where, before a render: shaders/lib/light_tree.glsl.

#include "device/packed_scene.h"

#include <functional>

namespace vkpt {

/// What the tables are made by: the shader library's own functions.
struct LightGridFunctions {
  /// lightImportance() of a node of the tree at a point, in local coordinates, for a unit normal or 0.
  std::function<float(std::uint32_t node, const Vec3f& p, const Vec3f& n)> importance;
  std::function<std::uint32_t(const Vec3f& n)> side; ///< lightGridSide()
};

/// Makes the grid of lights of a scene whose lights are chosen by a tree: a cut through the tree, and for
/// every cube that holds surfaces, and every side that these face, a table that chooses from it by what its
/// nodes may bring there; one by power for all other places. Every light can be chosen everywhere. The
/// numbers of PackedScene::lightGrid: where each table begins, by cube (guideCube()) and side, the last cube
/// for what lies outside of the grid; for every bin of a table, what lies below its node; the tables
/// (device/alias_bins.h). Where the tables choose worse than the tree, lights that are small and close to
/// surfaces in large cubes, the scene stays as it was. functions: makes a thread's own. threads: 0: as many
/// as the machine has; the result does not depend on them.
void makeLightGrid(PackedScene& scene, const Scene& source,
                   const std::function<LightGridFunctions()>& functions, unsigned threads = 0);

} // namespace vkpt
