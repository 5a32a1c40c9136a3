#pragma once
// A scene as the kernels read it: packed texels, and their upload.

#include "accel/bvh.h"
#include "device/effects.h"
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

/// How a surface with this material scatters in effect: without a specular lobe it is diffuse, and with
/// facets that hardly differ in direction smooth.
BsdfType effectiveBsdf(const Material& material);
/// False for a surface that reflects nothing, such as a lamp.
bool scatters(const Material& material);
/// Glass, smooth or rough.
bool transmits(const Material& material);
/// Glass with the same index on both sides that neither absorbs nor emits: light passes it as if it were not
/// there.
bool isNothing(const Material& material);
/// Whether it has a texture on which what it scatters depends.
bool readsTexture(const Material& material);

/// The scene in the device's layout (shaders/lib/records.glsl), in host memory: what is uploaded, and what
/// the host programs read. Never empty: unused arrays hold one dummy record.
struct PackedScene {
  Bvh bvh;
  std::vector<Texel> triangles; ///< kTexelsPerTriangle each, in BVH order
  std::vector<Texel> normals;   ///< the same
  std::vector<Texel> materials;
  std::vector<Texel> lights;
  std::vector<Texel> uvs;         ///< kTexelsPerUv a triangle, in BVH order
  std::vector<Texel> textures;    ///< one for each texture, then their pixels in half floats
  std::vector<Texel> environment; ///< kTexelsPerEnvironmentTexel for each of the map's
  LightChoice lightChoice;
  std::size_t leftOut = 0; ///< triangles whose material is nothing
};
/// What `effects` read is packed, the rest is a dummy of one record. Triangles of materials that are nothing
/// are left out whatever the effects.
PackedScene packScene(const Scene& scene, const EstimatorSettings& estimator, const EffectSet& effects,
                      unsigned threads = 0);
/// The same over a tree that was built for this scene before.
PackedScene packScene(const Scene& scene, const EstimatorSettings& estimator, const EffectSet& effects,
                      Bvh bvh);
/// For the effects that the scene calls for.
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
