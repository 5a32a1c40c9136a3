#include "trace_probe.h"

#include "device/effects.h"
#include "shared/structs.h"
#include "spirv.h"

namespace vkpt::spirv {
extern const std::span<const std::uint32_t> kTrace;
}

namespace vkpt::bench {
namespace {

using namespace shared;
using vk::DescriptorType;

constexpr std::uint32_t kBindingRays = kBindingCount;
constexpr std::uint32_t kBindingResults = kBindingCount + 1;
constexpr std::uint32_t kConstantShadow = 100;
constexpr std::uint32_t kConstantRaysPerLane = 101;

// So few that a subgroup stays far below the driver's limit of loop iterations (shared/structs.h,
// kStepBudget).
constexpr std::uint32_t kRaysPerLane = 32;

constexpr auto kLayout = std::to_array<gpu::BindingLayout>({
    {kBindingFrame, DescriptorType::eUniformBuffer},
    {kBindingCounters, DescriptorType::eStorageBuffer},
    {kBindingNodes, DescriptorType::eStorageTexelBuffer},
    {kBindingTriangles, DescriptorType::eStorageTexelBuffer},
    {kBindingRays, DescriptorType::eStorageTexelBuffer},
    {kBindingResults, DescriptorType::eStorageBuffer},
});

} // namespace

TraceProbe::TraceProbe(const gpu::Context& context, const DeviceScene& scene,
                       const std::vector<RecordedRay>& rays, bool shadow)
    : m_context(context), m_count(static_cast<std::uint32_t>(rays.size())),
      m_bindings(context, kLayout, sizeof(Dispatch)),
      m_pipeline(context, spirv::kTrace, m_bindings,
                 {{kConstantStackDepth, scene.stackDepth},
                  {kConstantShadow, shadow ? 1U : 0U},
                  {kConstantRaysPerLane, kRaysPerLane},
                  {static_cast<std::uint32_t>(Effect::LightSamples), 0U}}),
      m_frame(context, "frame constants", sizeof(FrameConstants), vk::BufferUsageFlagBits::eUniformBuffer,
              gpu::MemoryKind::Device),
      m_counters(context, "counters", sizeof(Counters), vk::BufferUsageFlagBits::eStorageBuffer,
                 gpu::MemoryKind::Device),
      m_rays(context, "recorded rays", std::as_bytes(std::span{rays})),
      m_results(context, "results", rays.size() * sizeof(float), vk::BufferUsageFlagBits::eStorageBuffer,
                gpu::MemoryKind::Device) {
  m_bindings.bind(context, kBindingFrame, m_frame, DescriptorType::eUniformBuffer);
  m_bindings.bind(context, kBindingCounters, m_counters, DescriptorType::eStorageBuffer);
  m_bindings.bind(context, kBindingNodes, scene.nodes);
  m_bindings.bind(context, kBindingTriangles, scene.triangles);
  m_bindings.bind(context, kBindingRays, m_rays);
  m_bindings.bind(context, kBindingResults, m_results, DescriptorType::eStorageBuffer);
  trace(); // the driver compiles at the first use
}

void TraceProbe::trace() const {
  m_context.execute([&](const vk::raii::CommandBuffer& commands) {
    Dispatch job{};
    job.slotCount = m_count;
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, m_pipeline.handle());
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, m_bindings.pipelineLayout(), 0,
                                m_bindings.set(), {});
    commands.pushConstants<Dispatch>(m_bindings.pipelineLayout(), vk::ShaderStageFlagBits::eCompute, 0, job);
    const std::uint32_t raysPerGroup = kBlockPixels * kRaysPerLane;
    commands.dispatch((m_count + raysPerGroup - 1) / raysPerGroup, 1, 1);
  });
}

std::vector<float> TraceProbe::results() const {
  std::vector<float> results(m_count);
  m_results.read(m_context, std::as_writable_bytes(std::span{results}));
  return results;
}

} // namespace vkpt::bench
