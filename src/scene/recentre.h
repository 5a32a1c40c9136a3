#pragma once
// The last steps of loading geometry, whatever its format: float coordinates about the scene's own centre,
// and no triangle among them that has no area or an exact twin.

#include "core/math.h"
#include "scene/scene.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vkpt {

/// Triangles of Scene::triangles that came from one file, in its order.
struct MeshPart {
  std::string name; ///< the file's, for messages
  std::size_t firstTriangle = 0;
  std::vector<std::uint32_t> lines; ///< of each triangle in the file
};

/// Sets Scene::origin to the middle of `world`, Scene::positions to the rest of it in float. Returns the box
/// of `world`.
Box3d recentre(Scene& scene, std::span<const Vec3d> world);

/// Drops triangles without area and those that lie exactly on an earlier one and show the same side, with a
/// warning for each part that had some. Throws SceneError where none is left. `parts` hold all triangles of
/// the scene.
void dropUseless(Scene& scene, std::span<const MeshPart> parts, SceneReport& report);

} // namespace vkpt
