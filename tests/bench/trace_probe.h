#pragma once
// Our traversal on the device, on recorded rays.

#include "device/device_scene.h"
#include "gpu/compute_pipeline.h"
#include "rays.h"

namespace vkpt::bench {

class TraceProbe {
public:
  TraceProbe(const gpu::Context& context, const DeviceScene& scene, const std::vector<RecordedRay>& rays,
             bool shadow);
  void trace() const;
  /// As EmbreeScene's, but 1e30 for no hit.
  [[nodiscard]] std::vector<float> results() const;

private:
  const gpu::Context& m_context;
  std::uint32_t m_count;
  gpu::BindingSet m_bindings;
  gpu::ComputePipeline m_pipeline;
  gpu::Buffer m_frame;    ///< the traversal alone reads nothing of it
  gpu::Buffer m_counters; ///< faults would be recorded here
  gpu::TexelBuffer m_rays;
  gpu::Buffer m_results;
};

} // namespace vkpt::bench
