#include "device/packed_light_node.h"

#include "shared/structs.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace vkpt {
namespace {

constexpr double kAxisSteps = 511.0; // to each side of 0: ten bits a component

std::uint32_t bits(double x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x)); }
double number(std::uint32_t bits) { return static_cast<double>(std::bit_cast<float>(bits)); }

} // namespace

void packLightNode(const LightTreeNode& node, double smallestRadius, std::vector<Texel>& out) {
  const LightBounds& b = node.bounds;
  const double radius = std::max(0.5 * glm::length(b.box.extent()), smallestRadius);
  std::uint32_t axis = 0;
  for (int i = 0; i < 3; ++i)
    axis |= (static_cast<std::uint32_t>(std::lround(kAxisSteps * b.axis[i])) +
             static_cast<std::uint32_t>(kAxisSteps))
            << (10 * i);
  const Vec3d c = b.box.centre();
  out.push_back({bits(c.x), bits(c.y), bits(c.z), bits(radius)});
  out.push_back({axis, bits(b.cosSpread), bits(b.power), node.below | (node.leaf ? shared::kLightLeaf : 0U)});
  out.push_back({node.parent, 0U, 0U, 0U});
}

PackedLightNode lightNodeOf(const PackedScene& scene, std::uint32_t i) {
  const Texel* t = &scene.lightNodes[std::size_t{i} * shared::kTexelsPerLightNode];
  PackedLightNode node;
  node.centre = {number(t[0][0]), number(t[0][1]), number(t[0][2])};
  node.radius = number(t[0][3]);
  for (int c = 0; c < 3; ++c)
    node.axis[c] = ((t[1][0] >> (10 * c)) & 1023U) / kAxisSteps - 1.0;
  node.cosSpread = number(t[1][1]);
  node.power = number(t[1][2]);
  node.leaf = (t[1][3] & shared::kLightLeaf) != 0U;
  node.below = t[1][3] & ~shared::kLightLeaf;
  node.bin = t[2][1];
  return node;
}

void setLightBin(PackedScene& scene, std::uint32_t node, std::uint32_t bin) {
  scene.lightNodes[std::size_t{node} * shared::kTexelsPerLightNode + 2][1] = bin;
}

} // namespace vkpt
