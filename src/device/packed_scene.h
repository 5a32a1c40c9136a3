#pragma once
// A scene as the kernels read it: packed texels.

#include "accel/bvh.h"
#include "device/cube_grid.h"
#include "device/effects.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace vkpt {

using Texel = std::array<std::uint32_t, 4>;

/// What light sampling chooses from.
struct LightChoice {
  std::uint32_t count = 0;
  float environmentProbability = 0.0F;
  bool byTree = false;         ///< else by power
  bool byTables = false;       ///< of the grid of lights, from the tree's root down
  bool belowTables = true;     ///< by the tree from there on: some of their bins stand for several lights
  std::uint32_t tableBits = 8; ///< a table has 2^tableBits bins
  std::uint32_t environmentLeaf = 0; ///< of the light tree, or its bin: as TriangleRecord::lightLeaf
  double totalPower = 0.0;           ///< as LightTable's
  CubeGrid guide;
  CubeGrid grid; ///< of lights
};

/// The scene in the device's layout (shaders/lib/records.glsl), in host memory: what is uploaded, and what
/// the host programs read. Never empty: unused arrays hold one dummy record.
struct PackedScene {
  Bvh bvh;
  std::vector<Texel> triangles; ///< kTexelsPerTriangle each, in BVH order
  std::vector<Texel> normals;   ///< the same
  std::vector<Texel> materials;
  std::vector<Texel> lights;
  std::vector<Texel> lightNodes;        ///< of the light tree: kTexelsPerLightNode each
  std::vector<Texel> uvs;               ///< kTexelsPerUv a triangle, in BVH order
  std::vector<Texel> textures;          ///< one for each texture, then their pixels in half floats
  std::vector<Texel> environment;       ///< kTexelsPerEnvironmentTexel for each of the map's
  std::vector<std::uint32_t> guide;     ///< device/guide.h
  std::vector<std::uint32_t> lightGrid; ///< device/light_grid.h
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

} // namespace vkpt
