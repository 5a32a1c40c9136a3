#pragma once
// The scenes that the benchmarks know by name.

#include "scene/scene.h"

#include <cstdint>
#include <string>

namespace vkpt::bench {

/// Throws UsageError for a name that is none. `mesh`: the file that the scene of that name shows in the box.
Scene loadByName(const std::string& name, int size, const fs::path& mesh = {});

/// The Cornell box with one bumpy ball of about so many triangles: one shape, however finely it is divided.
Scene boxWithBall(std::uint32_t triangles, int size);

/// What names stand for, for --help.
inline constexpr const char* kSceneNames =
    "blocks, spheres, busts (Phong), mesh, million (triangles), lights (1000 emissive triangles); "
    "ceiling, tiles (one lamp over all of the ceiling, and 1000 in its place); "
    "peers-blocks, peers-spheres (the box in which other renderers were measured); or files";

} // namespace vkpt::bench
