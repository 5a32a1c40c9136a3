#pragma once
// A packed scene on the device.

#include "device/packed_scene.h"
#include "gpu/buffer.h"

namespace vkpt {

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
