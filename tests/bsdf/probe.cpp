#include "bsdf/probe.h"

#include "bsdf/probe_shaders.h"
#include "device/camera_frame.h"
#include "host/learn_guide.h"
#include "scenes/test_shaders.h"

namespace vkpt::test {
namespace {

using namespace shared;
using vk::DescriptorType;

constexpr std::uint32_t kBindingQuery = kBindingCount;
constexpr std::uint32_t kBindingAnswers = kBindingCount + 1;
constexpr std::uint32_t kConstantRoutine = 100;
constexpr std::uint32_t kGroup = 64; // lanes
constexpr std::size_t kAnswerBytes = 32;

constexpr auto kLayout = std::to_array<gpu::BindingLayout>({
    {kBindingFrame, DescriptorType::eUniformBuffer},
    {kBindingMaterials, DescriptorType::eStorageTexelBuffer},
    {kBindingLights, DescriptorType::eStorageTexelBuffer},
    {kBindingLightNodes, DescriptorType::eStorageTexelBuffer},
    {kBindingEnvironment, DescriptorType::eStorageTexelBuffer},
    {kBindingGuide, DescriptorType::eStorageTexelBuffer},
    {kBindingLightGrid, DescriptorType::eStorageTexelBuffer},
    {kBindingQuery, DescriptorType::eStorageBuffer},
    {kBindingAnswers, DescriptorType::eStorageBuffer},
});

EstimatorSettings estimatorFor(const EffectSet& effects) {
  return {.lightSelection = effects.has(Effect::LightTree) ? LightSelection::Tree : LightSelection::Power};
}

std::array<float, 4> row(const Vec3f& v, float w) { return {v.x, v.y, v.z, w}; }

} // namespace

Probe::Probe(const Scene& scene, const EffectSet& effects, std::uint32_t mutation)
    : m_packed(packGuided(scene, estimatorFor(effects), effects, 1)),
      m_constants(frameConstants(scene, m_packed.lightChoice, {}, scene.width, scene.height, 0)),
      m_scene(uploadScene(sharedContext(), m_packed)), m_bindings(sharedContext(), kLayout, sizeof(Dispatch)),
      m_frame(sharedContext(), "frame constants", sizeof(FrameConstants),
              vk::BufferUsageFlagBits::eUniformBuffer, gpu::MemoryKind::Host),
      m_mutation(mutation) {
  const gpu::Context& context = sharedContext();
  m_frame.write(context, std::as_bytes(std::span{&m_constants, 1}));
  m_bindings.bind(context, kBindingFrame, m_frame, DescriptorType::eUniformBuffer);
  m_bindings.bind(context, kBindingMaterials, m_scene.materials);
  m_bindings.bind(context, kBindingLights, m_scene.lights);
  m_bindings.bind(context, kBindingLightNodes, m_scene.lightNodes);
  m_bindings.bind(context, kBindingEnvironment, m_scene.environment);
  m_bindings.bind(context, kBindingGuide, m_scene.guide);
  m_bindings.bind(context, kBindingLightGrid, m_scene.lightGrid);
  for (const EffectInfo& e : allEffects())
    m_specialisation[static_cast<std::uint32_t>(e.effect)] = effects.has(e.effect) ? 1U : 0U;
  m_specialisation[kConstantByLightTree] = m_packed.lightChoice.byTree ? 1U : 0U;
  m_specialisation[kConstantByLightTables] = m_packed.lightChoice.byTables ? 1U : 0U;
  m_specialisation[kConstantLightTableBits] = m_packed.lightChoice.tableBits;
  m_specialisation[kConstantBelowLightTables] = m_packed.lightChoice.belowTables ? 1U : 0U;
  m_specialisation[kConstantFilterShape] = static_cast<std::uint32_t>(scene.filter.shape);
  if (mutation != 0)
    m_specialisation.merge(mutatedKernel(mutation).constants());
}

const gpu::ComputePipeline& Probe::pipeline(Routine routine) {
  if (!m_pipelines.contains(routine)) {
    m_specialisation[kConstantRoutine] = static_cast<std::uint32_t>(routine);
    m_pipelines.try_emplace(routine, sharedContext(), m_mutation == 0 ? spirv::kProbe : spirv::kMutableProbe,
                            m_bindings, m_specialisation);
  }
  return m_pipelines.at(routine);
}

template<class Answer>
std::vector<Answer> Probe::run(Routine routine, const Query& query, std::uint32_t count, std::uint32_t seed) {
  static_assert(sizeof(Answer) == kAnswerBytes);
  const gpu::Context& context = sharedContext();
  const gpu::ComputePipeline& chosen = pipeline(routine);
  const auto usage = vk::BufferUsageFlagBits::eStorageBuffer;
  const gpu::Buffer in(context, "query", std::as_bytes(std::span{query}).size(), usage,
                       gpu::MemoryKind::Host);
  const gpu::Buffer out(context, "answers", count * kAnswerBytes, usage, gpu::MemoryKind::Host);
  in.write(context, std::as_bytes(std::span{query}));
  m_bindings.bind(context, kBindingQuery, in, DescriptorType::eStorageBuffer);
  m_bindings.bind(context, kBindingAnswers, out, DescriptorType::eStorageBuffer);
  context.execute([&](const vk::raii::CommandBuffer& commands) {
    Dispatch job{};
    job.slotCount = count;
    job.firstSample = seed;
    commands.bindPipeline(vk::PipelineBindPoint::eCompute, chosen.handle());
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, m_bindings.pipelineLayout(), 0,
                                m_bindings.set(), {});
    commands.pushConstants<Dispatch>(m_bindings.pipelineLayout(), vk::ShaderStageFlagBits::eCompute, 0, job);
    commands.dispatch((count + kGroup - 1) / kGroup, 1, 1);
    const vk::MemoryBarrier toHost(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead);
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader, vk::PipelineStageFlagBits::eHost, {},
                             toHost, {}, {});
  });
  std::vector<Answer> answers(count);
  out.read(context, std::as_writable_bytes(std::span{answers}));
  return answers;
}

namespace {

std::vector<std::array<float, 4>> queryOf(const View& view) {
  return {row(view.wo, static_cast<float>(view.material)), row(view.n, view.front ? 1.0F : 0.0F), {}};
}

} // namespace

std::vector<BsdfDraw> Probe::sampleBsdf(const View& view, std::uint32_t count, std::uint32_t seed) {
  return run<BsdfDraw>(Routine::SampleBsdf, queryOf(view), count, seed);
}

std::vector<BsdfAnswer> Probe::evaluateBsdf(const View& view, std::span<const Vec3f> directions) {
  Query query = queryOf(view);
  query.pop_back();
  for (const Vec3f& wi : directions)
    query.push_back(row(wi, 0.0F));
  return run<BsdfAnswer>(Routine::EvaluateBsdf, query, static_cast<std::uint32_t>(directions.size()), 0);
}

std::vector<LightDraw> Probe::sampleLight(const Vec3f& p, std::uint32_t count, std::uint32_t seed,
                                          const Vec3f& n) {
  return run<LightDraw>(Routine::SampleLight, {row(p, 0.0F), row(n, 0.0F), {}}, count, seed);
}

std::vector<EnvironmentDraw> Probe::sampleEnvironment(std::uint32_t count, std::uint32_t seed) {
  return run<EnvironmentDraw>(Routine::SampleEnvironment, Query(3), count, seed);
}

std::vector<FilterDraw> Probe::sampleFilter(std::uint32_t count, std::uint32_t seed) {
  return run<FilterDraw>(Routine::SampleFilter, Query(3), count, seed);
}

} // namespace vkpt::test
