#pragma once
// How time grows with the number of triangles.

#include "gpu/context.h"
#include "races.h"

#include <nlohmann/json.hpp>

namespace vkpt::bench {

/// One shape in 1 k to 1 M triangles: time of a sample, bounce rays, the build of the BVH. Prints a table;
/// returns it with the fit time = a + b log2(triangles).
nlohmann::json measureScaling(const gpu::Context& context, const Turns& turns, int size);

} // namespace vkpt::bench
