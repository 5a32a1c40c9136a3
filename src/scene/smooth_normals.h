#pragma once
// Vertex normals for files that have none.

#include "core/math.h"
#include "scene/scene.h"

#include <cstddef>
#include <span>
#include <vector>

namespace vkpt {

/// The rule of the assignment's framework: the unit normals of the faces weighted by the angle of the corner
/// and summed per position index. Triangles index `positions`; each gets its corners' normals, unless all
/// three are its geometric normal (a flat face needs no shading normals) or one of them cancels out. Returns
/// one normal for every position (zero where none is used); `count` is how many are used.
std::vector<Vec3d> makeSmoothNormals(std::span<const Vec3d> positions, std::span<Triangle> triangles,
                                     std::size_t& count);

} // namespace vkpt
