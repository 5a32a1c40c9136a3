#include "device/device_scene.h"

namespace vkpt {

DeviceScene uploadScene(const gpu::Context& context, const PackedScene& packed) {
  DeviceScene scene;
  scene.nodes = gpu::TexelBuffer(context, "BVH nodes", std::as_bytes(std::span{packed.bvh.nodes}));
  scene.triangles = gpu::TexelBuffer(context, "triangles", std::as_bytes(std::span{packed.triangles}));
  scene.normals = gpu::TexelBuffer(context, "normals", std::as_bytes(std::span{packed.normals}));
  scene.materials = gpu::TexelBuffer(context, "materials", std::as_bytes(std::span{packed.materials}));
  scene.lights = gpu::TexelBuffer(context, "lights", std::as_bytes(std::span{packed.lights}));
  scene.uvs = gpu::TexelBuffer(context, "texture coordinates", std::as_bytes(std::span{packed.uvs}));
  scene.textures = gpu::TexelBuffer(context, "textures", std::as_bytes(std::span{packed.textures}));
  scene.environment = gpu::TexelBuffer(context, "environment", std::as_bytes(std::span{packed.environment}));
  scene.lightChoice = packed.lightChoice;
  scene.stackDepth = packed.bvh.depth + 1U;
  return scene;
}

std::uint64_t DeviceScene::bytes() const {
  return nodes.bytes() + triangles.bytes() + normals.bytes() + materials.bytes() + lights.bytes() +
         uvs.bytes() + textures.bytes() + environment.bytes();
}

} // namespace vkpt
