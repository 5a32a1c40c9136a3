#pragma once
// A scene as the kernels read it: packed texels, and their upload.

#include "accel/bvh.h"
#include "gpu/buffer.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace vkpt {

using Texel = std::array<std::uint32_t, 4>;

/// The scene in the device's layout (shaders/lib/records.glsl), in host memory: what is uploaded, and what
/// the host programs read. Never empty: unused arrays hold one dummy texel.
struct PackedScene {
  Bvh bvh;
  std::vector<Texel> triangles; ///< kTexelsPerTriangle each, in BVH order
  std::vector<Texel> normals;   ///< the same, or a dummy for flat scenes
  std::vector<Texel> materials;
  std::vector<Texel> lights;
  std::uint32_t lightCount = 0;
};
PackedScene packScene(const Scene& scene, unsigned threads = 0);

struct DeviceScene {
  gpu::TexelBuffer nodes;
  gpu::TexelBuffer triangles;
  gpu::TexelBuffer normals;
  gpu::TexelBuffer materials;
  gpu::TexelBuffer lights;
  std::uint32_t lightCount = 0;
  std::uint32_t stackDepth = 0; ///< entries a traversal needs: shaders/lib/stack.glsl
  [[nodiscard]] std::uint64_t bytes() const;
};
DeviceScene uploadScene(const gpu::Context& context, const PackedScene& packed);

} // namespace vkpt
