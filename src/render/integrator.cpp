#include "render/integrator.h"

#include "device/camera_frame.h"
#include "render/memory_plan.h"
#include "spirv.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

namespace vkpt {
namespace {

using namespace shared;
using vk::DescriptorType;

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
    {kBindingFilm, DescriptorType::eStorageBuffer, kFilmPlanes},
    {kBindingSlots, DescriptorType::eStorageBuffer},
    {kBindingUvs, DescriptorType::eStorageTexelBuffer},
    {kBindingTextures, DescriptorType::eStorageTexelBuffer},
    {kBindingEnvironment, DescriptorType::eStorageTexelBuffer},
    {kBindingGuide, DescriptorType::eStorageTexelBuffer},
    {kBindingLightGrid, DescriptorType::eStorageTexelBuffer},
    {kBindingKinds, DescriptorType::eStorageBuffer, kKindCount},
    {kBindingReplicates, DescriptorType::eStorageTexelBuffer, 3},
    {kBindingSplats, DescriptorType::eStorageTexelBuffer},
    {kBindingReuse, DescriptorType::eStorageTexelBuffer},
    {kBindingConnections, DescriptorType::eStorageTexelBuffer},
});
static_assert(kLayout.size() == kBindingCount);

/// Slots left below which another dispatch costs more than idle lanes do.
constexpr std::uint32_t kLeastWorthPacking = 256;

gpu::SpecialisationMap specialise(const DeviceScene& scene, const Scene& source, const EffectSet& effects,
                                  const IntegratorSettings& settings) {
  gpu::SpecialisationMap constants = kernelConstants(scene, source, effects, settings.estimator);
  for (const auto& [id, value] : settings.extraConstants)
    constants[id] = value;
  return constants;
}

/// A work-group for every block, or for every kBlockPixels listed slots.
std::uint32_t workGroups(const Dispatch& job) {
  return job.listed > 0 ? (job.listed + kBlockPixels - 1) / kBlockPixels : job.blockCount;
}

void barrier(const vk::raii::CommandBuffer& commands) {
  using Access = vk::AccessFlagBits;
  using Stage = vk::PipelineStageFlagBits;
  const vk::MemoryBarrier all(Access::eShaderWrite, Access::eShaderRead | Access::eShaderWrite |
                                                        Access::eHostRead | Access::eTransferRead);
  commands.pipelineBarrier(Stage::eComputeShader, Stage::eComputeShader | Stage::eHost | Stage::eTransfer, {},
                           all, {}, {});
}

} // namespace

Integrator::Integrator(const gpu::Context& context, const DeviceScene& scene, const Scene& source,
                       const EffectSet& effects, const IntegratorSettings& settings)
    : m_context(context), m_settings(settings), m_lightTree(effects.has(Effect::LightTree)),
      m_constants(frameConstants(source, scene.lightChoice, settings.estimator, settings.width,
                                 settings.height, settings.seed)),
      m_bindings(context, kLayout, sizeof(Dispatch)),
      m_path(context, settings.shaders.path, m_bindings, specialise(scene, source, effects, settings)),
      m_commit(context, spirv::kCommit, m_bindings,
               {{static_cast<std::uint32_t>(Effect::KindImages), effects.has(Effect::KindImages) ? 1U : 0U},
                {kConstantSampler, static_cast<std::uint32_t>(settings.estimator.sampler)}}),
      m_constantsBuffer(context, "frame constants", sizeof(FrameConstants),
                        vk::BufferUsageFlagBits::eUniformBuffer, gpu::MemoryKind::Host),
      m_countersBuffer(context, "counters", sizeof(Counters), vk::BufferUsageFlagBits::eStorageBuffer,
                       gpu::MemoryKind::Host),
      m_film(context, settings.width, settings.height),
      m_kinds(context, settings.width, settings.height, effects.has(Effect::KindImages)),
      m_replicates(context, settings.width, settings.height, settings.estimator.sampler == Sampler::Sobol),
      m_splats(context, settings.width, settings.height,
               m_constants.tracesLights != 0 && effects.has(Effect::LightTracing)),
      m_reuse(context, m_bindings, settings.shaders.reuse, specialise(scene, source, effects, settings),
              effects.has(Effect::PathReuse) ? settings.estimator.reuseEdge() : 1, m_lightTree) {
  m_constants.tracesLights = m_splats.wanted() ? 1 : 0;
  if (m_splats.wanted()) {
    gpu::SpecialisationMap constants = specialise(scene, source, effects, settings);
    constants[kConstantFromLight] = 1;
    m_lightPath.emplace(context, settings.shaders.path, m_bindings, constants);
  }
  m_constantsBuffer.write(context, std::as_bytes(std::span{&m_constants, 1}));
  m_bindings.bind(context, kBindingFrame, m_constantsBuffer, DescriptorType::eUniformBuffer);
  bindScene(context, m_bindings, scene);
  m_bindings.bind(context, kBindingCounters, m_countersBuffer, DescriptorType::eStorageBuffer);
  m_film.bind(context, m_bindings);
  m_kinds.bind(context, m_bindings);
  m_replicates.bind(context, m_bindings);
  m_splats.bind(context, m_bindings, kBindingSplats);
  reserveSlots(kBlockPixels);
}

std::uint32_t Integrator::blockCount() const {
  // Blocks follow one another where a stripe holds one: those behind the last would cost as much as the
  // others.
  const std::uint32_t rows = (m_constants.height + kBlockEdge - 1) / kBlockEdge;
  return m_constants.blocksPerStripe == 1 ? m_constants.blocksX * rows
                                          : m_constants.blocksPerStripe * kStripes;
}

void Integrator::reserveSlots(std::uint32_t slots) {
  if (slots <= m_slots)
    return;
  m_slots = std::bit_ceil(slots);
  m_paths = gpu::Buffer(m_context, "path states",
                        pathStateBytes(m_slots, m_settings.estimator.splitDepth, m_lightTree),
                        vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryKind::Device);
  m_slotLists = gpu::Buffer(m_context, "slot lists", slotListBytes(m_slots),
                            vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryKind::Device);
  m_bindings.bind(m_context, kBindingPaths, m_paths, DescriptorType::eStorageBuffer);
  m_bindings.bind(m_context, kBindingSlots, m_slotLists, DescriptorType::eStorageBuffer);
}

void Integrator::dispatch(vk::Pipeline pipeline, const Dispatch& job, std::uint32_t y,
                          std::uint32_t z) const {
  m_context.execute([&](const vk::raii::CommandBuffer& commands) {
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, pipeline);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, m_bindings.pipelineLayout(), 0,
                                m_bindings.set(), {});
    commands.pushConstants<Dispatch>(m_bindings.pipelineLayout(), vk::ShaderStageFlagBits::eCompute, 0, job);
    commands.dispatch(workGroups(job), y, z);
    barrier(commands);
  });
}

Counters Integrator::traceOnce(vk::Pipeline pipeline, const Dispatch& job, std::uint32_t y, std::uint32_t z) {
  std::memset(m_countersBuffer.mapped(), 0, sizeof(Counters));
  dispatch(pipeline, job, y, z);
  Counters c{};
  std::memcpy(&c, m_countersBuffer.mapped(), sizeof(Counters));
  m_counters.raysClosest += c.raysClosest;
  m_counters.raysShadow += c.raysShadow;
  m_counters.cappedPaths += c.cappedPaths;
  m_counters.carriedPaths += c.carriedPaths;
  m_counters.nonFinite += c.nonFinite;
  m_counters.cutTraversal += c.cutTraversal;
  m_counters.stackOverflow += c.stackOverflow;
  m_counters.invalidPdf += c.invalidPdf;
  ++m_counters.dispatches;
  keepFaults(c, job);
  return c;
}

void Integrator::keepFaults(const Counters& c, const Dispatch& job) {
  const std::uint32_t recorded = std::min(c.faultRecords, kMaxFaultRecords);
  for (std::uint32_t i = 0; i < recorded && m_faults.size() < kMaxFaultRecords; ++i) {
    const FaultRecord& r = c.records[i];
    const auto width = static_cast<std::uint32_t>(m_settings.width);
    m_faults.push_back({static_cast<int>(r.pixel % width), static_cast<int>(r.pixel / width),
                        (std::uint64_t{job.firstSampleHigh} << 32U) | r.sampleLow, r.bounce,
                        static_cast<FaultCause>(r.cause)});
  }
}

void Integrator::tracePaths(const gpu::ComputePipeline& pipeline, Dispatch job,
                            const std::function<void()>& between) {
  // Every dispatch takes each unfinished path at least one vertex further, and no path is longer than
  // kBounceCap.
  while ((job.listed = traceOnce(pipeline.handle(), job).unfinished) > 0) {
    job.fresh = 0;
    job.packs = job.listed > kLeastWorthPacking ? 1 : 0;
    job.listTurn ^= 1U;
    if (between)
      between();
  }
}

void Integrator::beginPaths(Dispatch job, const std::function<void()>& between) {
  while (traceOnce(m_reuse.firstVertices(), job, job.sampleCount).unfinished > 0) {
    job.fresh = 0;
    if (between)
      between();
  }
}

void Integrator::sharePaths(const Dispatch& job, const std::function<void()>& between) {
  traceOnce(m_reuse.step(kStepConnect), job, job.sampleCount, m_reuse.pixels());
  if (between)
    between();
  dispatch(m_reuse.step(kStepBalance), job, job.sampleCount);
  dispatch(m_reuse.step(kStepAddUp), job);
}

std::uint64_t Integrator::renderTile(const Tile& tile, std::uint64_t firstSample, std::uint32_t count,
                                     const std::function<void()>& between) {
  assert(firstSample % kSamplesPerGroup + count <= kSamplesPerGroup);
  const std::uint32_t most =
      m_reuse.wanted() ? std::min(tile.blockCount, kMostSharedBlocks) : tile.blockCount;
  for (std::uint32_t done = 0; done < tile.blockCount; done += most)
    renderPart({tile.firstBlock + done, std::min(most, tile.blockCount - done)}, firstSample, count, between);
  const std::uint64_t samples = std::uint64_t{tile.blockCount} * kBlockPixels * count;
  m_counters.samples += samples;
  m_lightPaths += pixelsOf(tile) * count;
  return samples;
}

void Integrator::renderPart(const Tile& tile, std::uint64_t firstSample, std::uint32_t count,
                            const std::function<void()>& between) {
  Dispatch job{};
  job.firstBlock = tile.firstBlock;
  job.blockCount = tile.blockCount;
  job.slotCount = tile.blockCount * kBlockPixels;
  job.firstSample = static_cast<std::uint32_t>(firstSample);
  job.firstSampleHigh = static_cast<std::uint32_t>(firstSample >> 32U);
  job.sampleCount = count;
  job.fresh = 1;
  job.packs = 1;
  reserveSlots(job.slotCount);
  m_reuse.reserve(m_context, m_bindings, job.slotCount, count);
  if (m_lightPath)
    tracePaths(*m_lightPath, job, between);
  if (m_reuse.wanted() && count > 0)
    beginPaths(job, between);
  tracePaths(m_path, job, between);
  if (count == 0)
    return;
  if (m_reuse.wanted())
    sharePaths(job, between);
  dispatch(m_commit.handle(), job);
}

/// Blocks at the image's edges are cut, some lie outside of it (device_memory.glsl: pixelOfSlot).
std::uint64_t Integrator::pixelsOf(const Tile& tile) const {
  std::uint64_t pixels = 0;
  for (std::uint32_t i = tile.firstBlock; i < tile.firstBlock + tile.blockCount; ++i) {
    if (i / kStripes >= m_constants.blocksPerStripe)
      continue;
    const std::uint32_t block = (i % kStripes) * m_constants.blocksPerStripe + i / kStripes;
    const std::uint32_t x = block % m_constants.blocksX * kBlockEdge;
    const std::uint32_t y = block / m_constants.blocksX * kBlockEdge;
    if (y < m_constants.height)
      pixels += std::uint64_t{std::min(m_constants.width - x, kBlockEdge)} *
                std::min(m_constants.height - y, kBlockEdge);
  }
  return pixels;
}

SplatScale Integrator::splatUnits() const {
  if (m_lightPaths == 0 || m_constants.tracesLights == 0)
    return {0.0F, 0.0F};
  const double frames = static_cast<double>(m_lightPaths) / m_constants.width / m_constants.height;
  return {static_cast<float>(1.0 / (static_cast<double>(m_constants.splatUnits) * frames)),
          static_cast<float>(1.0 / (static_cast<double>(m_constants.splatSquareUnits) * frames * frames))};
}

void Integrator::clear() {
  m_film.clear(m_context);
  m_kinds.clear(m_context);
  m_replicates.clear(m_context);
  m_splats.clear(m_context);
  m_lightPaths = 0;
}

void Integrator::forget() {
  m_counters = {};
  m_faults.clear();
}

void Integrator::restart(std::uint32_t seed) {
  m_settings.seed = seed;
  m_constants.seed = seed;
  m_constantsBuffer.write(m_context, std::as_bytes(std::span{&m_constants, 1}));
  clear();
  forget();
}

void Integrator::restart(const Scene& source, int width, int height) {
  setView(m_constants, source, width, height);
  m_constantsBuffer.write(m_context, std::as_bytes(std::span{&m_constants, 1}));
  m_settings.width = width;
  m_settings.height = height;
  m_film.resize(m_context, width, height);
  m_film.bind(m_context, m_bindings);
  m_kinds.resize(m_context, width, height);
  m_kinds.bind(m_context, m_bindings);
  m_replicates.resize(m_context, width, height);
  m_replicates.bind(m_context, m_bindings);
  m_splats.resize(m_context, width, height);
  m_splats.bind(m_context, m_bindings, kBindingSplats);
  m_lightPaths = 0;
  forget();
}

Film RawFilm::film() const {
  Film film{width, height, std::vector<PixelMoments>(planes.front().size())};
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    film.pixels[i] = momentsAt(planes, i);
    if (!replicates[0].empty())
      addReplicates(film.pixels[i], replicates, i);
  }
  if (!splats.empty())
    splats.addTo(film, splatScale);
  return film;
}

RawFilm Integrator::rawFilm() const {
  const auto pixels =
      static_cast<std::size_t>(m_settings.width) * static_cast<std::size_t>(m_settings.height);
  return {m_settings.width,
          m_settings.height,
          m_film.download(m_context, 0, pixels),
          m_replicates.download(m_context, 0, pixels),
          m_splats.download(m_context),
          splatScale()};
}

PixelMoments Integrator::pixel(int x, int y) const {
  const auto index =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(m_settings.width) + static_cast<std::size_t>(x);
  PixelMoments moments =
      RawFilm{1, 1, m_film.download(m_context, index, 1), m_replicates.download(m_context, index, 1), {}, {}}
          .film()
          .pixels.front();
  if (const SplatSums splats = m_splats.download(m_context); !splats.empty()) {
    const auto paths = static_cast<double>(m_lightPaths);
    splats.addTo(moments, index, splatScale(), paths / m_settings.width / m_settings.height, paths);
  }
  return moments;
}

std::vector<std::vector<Vec3d>> Integrator::kindImages(const Film& film) const {
  std::vector<std::uint64_t> samples;
  for (const PixelMoments& pixel : film.pixels)
    samples.push_back(pixel.count);
  return m_kinds.download(m_context, samples);
}

void Integrator::warmUp() {
  renderTile({0, 1}, 0, 0);
  m_counters = {};
}

} // namespace vkpt
