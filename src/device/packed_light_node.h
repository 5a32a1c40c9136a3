#pragma once
// A node of the light tree as the kernels read it (shaders/lib/records.glsl: LightNode, LightNodePlace).

#include "device/light_tree.h"
#include "device/packed_scene.h"

namespace vkpt {

struct PackedLightNode {
  Vec3d centre{0.0}; ///< of a sphere about its lights, in local coordinates
  double radius = 0.0;
  Vec3d axis{0.0}; ///< of the cone of their normals
  double cosSpread = 1.0;
  double power = 0.0;
  std::uint32_t below = 0; ///< the first of two children; of a leaf the light
  bool leaf = false;
  std::uint32_t bin = 0; ///< of the tables of the grid of lights, and one; 0: none chooses this node
};
void packLightNode(const LightTreeNode& node, double smallestRadius, std::vector<Texel>& out);
/// Of a scene whose lights are chosen by a tree.
PackedLightNode lightNodeOf(const PackedScene& scene, std::uint32_t i);
void setLightBin(PackedScene& scene, std::uint32_t node, std::uint32_t bin);

} // namespace vkpt
