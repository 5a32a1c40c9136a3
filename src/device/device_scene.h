#pragma once
// A packed scene on the device.

#include "device/effects.h"
#include "device/packed_scene.h"
#include "gpu/compute_pipeline.h"

namespace vkpt {

struct DeviceScene {
  gpu::TexelBuffer nodes;
  gpu::TexelBuffer triangles;
  gpu::TexelBuffer normals;
  gpu::TexelBuffer materials;
  gpu::TexelBuffer lights;
  gpu::TexelBuffer lightNodes;
  gpu::TexelBuffer uvs;
  gpu::TexelBuffer textures;
  gpu::TexelBuffer environment;
  gpu::TexelBuffer guide;
  gpu::TexelBuffer lightGrid;
  LightChoice lightChoice;
  std::uint32_t stackDepth = 0; ///< entries a traversal needs: shaders/lib/stack.glsl
  [[nodiscard]] std::uint64_t bytes() const;
};
DeviceScene uploadScene(const gpu::Context& context, const PackedScene& packed);

/// Binds its texel buffers where shaders/device_memory.glsl has them.
void bindScene(const gpu::Context& context, const gpu::BindingSet& bindings, const DeviceScene& scene);

/// What a kernel that traces paths is specialised by.
gpu::SpecialisationMap kernelConstants(const DeviceScene& scene, const Scene& source,
                                       const EffectSet& effects, const EstimatorSettings& estimator);

} // namespace vkpt
