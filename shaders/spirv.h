#pragma once
// The compiled shaders, embedded in the binary.

#include <cstdint>
#include <span>

namespace vkpt::spirv {

extern const std::span<const std::uint32_t> kPath;          ///< path.comp
extern const std::span<const std::uint32_t> kFirstVertices; ///< first_vertices.comp
extern const std::span<const std::uint32_t> kSharePaths;    ///< share_paths.comp
extern const std::span<const std::uint32_t> kCommit;        ///< commit.comp

} // namespace vkpt::spirv
