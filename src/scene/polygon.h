#pragma once
// Faces of any number of corners into triangles.

#include "core/math.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vkpt {

/// Concave faces are cut in quadratic to cubic time; more corners than this are refused by the loader.
inline constexpr std::size_t kMostConcaveCorners = 4096;

enum class PolygonKind {
  Simple,  ///< the triangles cover it exactly
  Crossed, ///< it crosses itself or has no plane: a fan, whatever that covers
  TooLarge ///< concave with more than kMostConcaveCorners corners: no triangles
};

/// Appends triangles (indices into `corners`) that keep the winding. A convex face without corners in the
/// middle of a straight edge becomes the fan (0,1,2), (0,2,3), ... that the assignment's framework makes.
PolygonKind triangulate(std::span<const Vec3d> corners, std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace vkpt
