#include "selftest/record_paths.h"

#include "device/camera_frame.h"
#include "host/learn_guide.h"
#include "selftest/shaders.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vkpt::selftest {
namespace {

using namespace shared;
using vk::DescriptorType;

constexpr std::uint32_t kBindingRecords = kBindingCount;
constexpr auto kLayout = std::to_array<gpu::BindingLayout>({
    {kBindingFrame, DescriptorType::eUniformBuffer},
    {kBindingNodes, DescriptorType::eStorageTexelBuffer},
    {kBindingTriangles, DescriptorType::eStorageTexelBuffer},
    {kBindingNormals, DescriptorType::eStorageTexelBuffer},
    {kBindingMaterials, DescriptorType::eStorageTexelBuffer},
    {kBindingLights, DescriptorType::eStorageTexelBuffer},
    {kBindingLightNodes, DescriptorType::eStorageTexelBuffer},
    {kBindingPaths, DescriptorType::eStorageBuffer},
    {kBindingCounters, DescriptorType::eStorageBuffer},
    {kBindingUvs, DescriptorType::eStorageTexelBuffer},
    {kBindingTextures, DescriptorType::eStorageTexelBuffer},
    {kBindingEnvironment, DescriptorType::eStorageTexelBuffer},
    {kBindingGuide, DescriptorType::eStorageTexelBuffer},
    {kBindingLightGrid, DescriptorType::eStorageTexelBuffer},
    {kBindingKinds, DescriptorType::eStorageBuffer, kKindCount},
    {kBindingSplats, DescriptorType::eStorageTexelBuffer},
    {kBindingRecords, DescriptorType::eStorageBuffer},
});

gpu::SpecialisationMap constantsOf(const Kernel& kernel, const OracleScene& s, const DeviceScene& scene) {
  gpu::SpecialisationMap constants = kernelConstants(scene, s.scene, s.effects, s.settings.estimator);
  constants.merge(kernel.constants());
  return constants;
}

} // namespace

OracleScene oracleScene(const Scene& scene, const EstimatorSettings& estimator, int width, int height,
                        std::uint32_t seed) {
  const EffectSet effects = detectEffects(scene, estimator);
  return {scene, {estimator, width, height, seed}, effects, packGuided(scene, estimator, effects, 1)};
}

std::vector<PathRecord> recordPaths(const Trial& t, const OracleScene& s, std::uint32_t sample) {
  const gpu::Context& context = t.context();
  const DeviceScene scene = uploadScene(context, s.packed);
  const gpu::BindingSet bindings(context, kLayout, sizeof(Dispatch));
  const gpu::ComputePipeline pipeline(context, t.kernel().of(spirv::kPathRecords), bindings,
                                      constantsOf(t.kernel(), s, scene));
  const FrameConstants frame = frameConstants(s.scene, s.packed.lightChoice, s.settings.estimator,
                                              s.settings.width, s.settings.height, s.settings.seed);
  std::vector<PathRecord> records(static_cast<std::size_t>(s.settings.width) *
                                  static_cast<std::size_t>(s.settings.height));
  const auto storage = vk::BufferUsageFlagBits::eStorageBuffer;
  const gpu::Buffer constants(context, "frame constants", sizeof frame,
                              vk::BufferUsageFlagBits::eUniformBuffer, gpu::MemoryKind::Host);
  const gpu::Buffer counters(context, "counters", sizeof(Counters), storage, gpu::MemoryKind::Host);
  const gpu::Buffer unused(context, "unused", sizeof(Counters), storage, gpu::MemoryKind::Host);
  const gpu::Buffer out(context, "path records", std::as_bytes(std::span{records}).size(), storage,
                        gpu::MemoryKind::Host);
  constants.write(context, std::as_bytes(std::span{&frame, 1}));
  counters.fillZero(context);
  out.fillZero(context);
  bindScene(context, bindings, scene);
  bindings.bind(context, kBindingFrame, constants, DescriptorType::eUniformBuffer);
  bindings.bind(context, kBindingCounters, counters, DescriptorType::eStorageBuffer);
  bindings.bind(context, kBindingPaths, unused, DescriptorType::eStorageBuffer);
  for (std::uint32_t k = 0; k < kKindCount; ++k)
    bindings.bind(context, kBindingKinds, unused, DescriptorType::eStorageBuffer, k);
  const gpu::TexelBuffer noSplats(context, "splats", 4, vk::Format::eR32Uint);
  bindings.bind(context, kBindingSplats, noSplats);
  bindings.bind(context, kBindingRecords, out, DescriptorType::eStorageBuffer);
  context.execute([&](const vk::raii::CommandBuffer& commands) {
    Dispatch job{};
    job.slotCount = static_cast<std::uint32_t>(records.size());
    job.firstSample = sample;
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline.handle());
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, bindings.pipelineLayout(), 0, bindings.set(),
                                {});
    commands.pushConstants<Dispatch>(bindings.pipelineLayout(), vk::ShaderStageFlagBits::eCompute, 0, job);
    commands.dispatch((job.slotCount + kBlockPixels - 1) / kBlockPixels, 1, 1);
    const vk::MemoryBarrier toHost(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {},
                             toHost, {}, {});
  });
  out.read(context, std::as_writable_bytes(std::span{records}));
  return records;
}

namespace {

Vec3d vectorOf(const vec4& v) { return {v.x, v.y, v.z}; }

/// The ray that led to a vertex came from the same decisions: rounding alone, magnified by curved glass,
/// turns a direction by far less than another lobe does.
bool sameWay(const VertexRecord& device, const ReplayStep& host) {
  constexpr double kMostTurn = 0.05; // radians
  return glm::length(vectorOf(device.direction) - host.direction) < kMostTurn;
}

} // namespace

Parting partingOf(const PathRecord& device, const Replay& host, double least) {
  // One of them has found light, and what the other has is next to nothing beside it.
  const auto seenByOne = [least](const Vec3d& a, const Vec3d& b) {
    return glm::length(a - b) > least && std::min(glm::length(a), glm::length(b)) < 1e-3 * glm::length(a - b);
  };
  const std::size_t count = std::min<std::size_t>({device.count, host.steps.size(), kRecordedVertices});
  for (std::size_t i = 0; i < count; ++i) {
    const VertexRecord& d = device.vertices[i];
    const ReplayStep& h = host.steps[i];
    if (!sameWay(d, h))
      return Parting::Lobe;
    const std::uint32_t triangle = h.hit ? h.triangle : 0xFFFFFFFFU;
    if (d.triangle != triangle || (h.hit && ((d.flags & kVertexFront) != 0) != h.front))
      return Parting::Triangle;
    if (seenByOne(vectorOf(d.gathered), h.gathered))
      return Parting::Shadow;
    if (((d.flags & kVertexGoesOn) != 0) != h.goesOn)
      return Parting::Roulette;
  }
  return device.count == host.steps.size() ? Parting::None : Parting::Roulette;
}

} // namespace vkpt::selftest
