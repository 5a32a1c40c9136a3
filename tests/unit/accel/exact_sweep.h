#pragma once
// The yardstick of quality: every cut along every axis, without bins.

#include "accel/bvh.h"
#include "unit/accel/meshes.h"

#include <span>

namespace vkpt::test {

/// A four-wide tree whose binary one is built by the exact surface area heuristic, with the costs and the
/// collapse of the library.
Bvh buildByExactSweep(std::span<const Box3f> boxes);

} // namespace vkpt::test
