#include "device/device_scene.h"

#include "shared/structs.h"

namespace vkpt {

DeviceScene uploadScene(const gpu::Context& context, const PackedScene& packed) {
  DeviceScene scene;
  scene.nodes = gpu::TexelBuffer(context, "BVH nodes", std::as_bytes(std::span{packed.bvh.nodes}));
  scene.triangles = gpu::TexelBuffer(context, "triangles", std::as_bytes(std::span{packed.triangles}));
  scene.normals = gpu::TexelBuffer(context, "normals", std::as_bytes(std::span{packed.normals}));
  scene.materials = gpu::TexelBuffer(context, "materials", std::as_bytes(std::span{packed.materials}));
  scene.lights = gpu::TexelBuffer(context, "lights", std::as_bytes(std::span{packed.lights}));
  scene.lightNodes = gpu::TexelBuffer(context, "light tree", std::as_bytes(std::span{packed.lightNodes}));
  scene.uvs = gpu::TexelBuffer(context, "texture coordinates", std::as_bytes(std::span{packed.uvs}));
  scene.textures = gpu::TexelBuffer(context, "textures", std::as_bytes(std::span{packed.textures}));
  scene.environment = gpu::TexelBuffer(context, "environment", std::as_bytes(std::span{packed.environment}));
  scene.guide = gpu::TexelBuffer(context, "guide", packed.guide.size(), vk::Format::eR32Uint);
  scene.guide.buffer().write(context, std::as_bytes(std::span{packed.guide}));
  scene.lightGrid =
      gpu::TexelBuffer(context, "grid of lights", packed.lightGrid.size(), vk::Format::eR32Uint);
  scene.lightGrid.buffer().write(context, std::as_bytes(std::span{packed.lightGrid}));
  scene.lightChoice = packed.lightChoice;
  scene.stackDepth = packed.bvh.depth + 1U;
  return scene;
}

void bindScene(const gpu::Context& context, const gpu::BindingSet& bindings, const DeviceScene& scene) {
  bindings.bind(context, shared::kBindingNodes, scene.nodes);
  bindings.bind(context, shared::kBindingTriangles, scene.triangles);
  bindings.bind(context, shared::kBindingNormals, scene.normals);
  bindings.bind(context, shared::kBindingMaterials, scene.materials);
  bindings.bind(context, shared::kBindingLights, scene.lights);
  bindings.bind(context, shared::kBindingLightNodes, scene.lightNodes);
  bindings.bind(context, shared::kBindingUvs, scene.uvs);
  bindings.bind(context, shared::kBindingTextures, scene.textures);
  bindings.bind(context, shared::kBindingEnvironment, scene.environment);
  bindings.bind(context, shared::kBindingGuide, scene.guide);
  bindings.bind(context, shared::kBindingLightGrid, scene.lightGrid);
}

gpu::SpecialisationMap kernelConstants(const DeviceScene& scene, const Scene& source,
                                       const EffectSet& effects, const EstimatorSettings& estimator) {
  gpu::SpecialisationMap constants;
  for (const EffectInfo& e : allEffects())
    constants[static_cast<std::uint32_t>(e.effect)] = effects.has(e.effect) ? 1U : 0U;
  constants[shared::kConstantStackDepth] = scene.stackDepth;
  constants[shared::kConstantRouletteMode] = static_cast<std::uint32_t>(estimator.roulette);
  constants[shared::kConstantByLightTree] = scene.lightChoice.byTree ? 1U : 0U;
  constants[shared::kConstantByLightTables] = scene.lightChoice.byTables ? 1U : 0U;
  constants[shared::kConstantLightTableBits] = scene.lightChoice.tableBits;
  constants[shared::kConstantBelowLightTables] = scene.lightChoice.belowTables ? 1U : 0U;
  constants[shared::kConstantReuseEdge] = estimator.reuseEdge();
  constants[shared::kConstantSampler] = static_cast<std::uint32_t>(estimator.sampler);
  constants[shared::kConstantFilterShape] = static_cast<std::uint32_t>(source.filter.shape);
  return constants;
}

std::uint64_t DeviceScene::bytes() const {
  return nodes.bytes() + triangles.bytes() + normals.bytes() + materials.bytes() + lights.bytes() +
         lightNodes.bytes() + uvs.bytes() + textures.bytes() + environment.bytes() + guide.bytes() +
         lightGrid.bytes();
}

} // namespace vkpt
