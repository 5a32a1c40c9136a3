#pragma once
// Scenes of bare triangles for the library's host programs.

#include "device/packed_scene.h"

#include <array>
#include <span>

namespace vkpt::test {

using Corners = std::array<Vec3f, 3>;

/// Triangles of one grey material, packed with their BVH.
PackedScene packTriangles(std::span<const Corners> triangles);
PackedScene oneTriangle();

} // namespace vkpt::test
