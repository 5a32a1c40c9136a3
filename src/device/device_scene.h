#pragma once
// A scene as the kernels read it: packed texels, and their upload.

#include "accel/bvh.h"
#include "device/estimator_settings.h"
#include "gpu/buffer.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace vkpt {

using Texel = std::array<std::uint32_t, 4>;

/// What light sampling chooses from.
struct LightChoice {
  std::uint32_t count = 0;
  float environmentProbability = 0.0F;
};

/// How a surface with this material scatters in effect: a Phong material without a specular lobe is diffuse.
BsdfType effectiveBsdf(const Material& material);
/// False for a surface that reflects nothing, such as a lamp.
bool scatters(const Material& material);

/// The scene in the device's layout (shaders/lib/records.glsl), in host memory: what is uploaded, and what
/// the host programs read. Never empty: unused arrays hold one dummy texel.
struct PackedScene {
  Bvh bvh;
  std::vector<Texel> triangles; ///< kTexelsPerTriangle each, in BVH order
  std::vector<Texel> normals;   ///< the same, or a dummy for flat scenes
  std::vector<Texel> materials;
  std::vector<Texel> lights;
  std::vector<Texel> uvs;         ///< kTexelsPerUv a triangle, in BVH order, or a dummy without textures
  std::vector<Texel> textures;    ///< one for each texture, then their pixels in half floats
  std::vector<Texel> environment; ///< kTexelsPerEnvironmentTexel for each of the map's
  LightChoice lightChoice;
};
PackedScene packScene(const Scene& scene, const EstimatorSettings& estimator, unsigned threads = 0);

struct DeviceScene {
  gpu::TexelBuffer nodes;
  gpu::TexelBuffer triangles;
  gpu::TexelBuffer normals;
  gpu::TexelBuffer materials;
  gpu::TexelBuffer lights;
  gpu::TexelBuffer uvs;
  gpu::TexelBuffer textures;
  gpu::TexelBuffer environment;
  LightChoice lightChoice;
  std::uint32_t stackDepth = 0; ///< entries a traversal needs: shaders/lib/stack.glsl
  [[nodiscard]] std::uint64_t bytes() const;
};
DeviceScene uploadScene(const gpu::Context& context, const PackedScene& packed);

} // namespace vkpt
