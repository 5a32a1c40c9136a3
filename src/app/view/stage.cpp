#include "app/view/stage.h"

#include "app/view/view_shaders.h"
#include "core/clock.h"
#include "host/learn_guide.h"

namespace vkpt {
namespace {

/// What the views of the first hit are made of.
EffectSet primaryEffects(const EffectSet& effects) {
  EffectSet kept;
  for (const Effect e : {Effect::SmoothNormals, Effect::Textures, Effect::PixelFilter})
    kept.set(e, effects.has(e));
  return kept;
}

} // namespace

Stage::Stage(const gpu::Context& context, const RenderOptions& options, Scene& scene)
    : m_context(context), m_options(options), m_scene(scene) {}

void Stage::pack(const EstimatorSettings& estimator) {
  const Stopwatch watch;
  m_detected = detectEffects(m_scene, estimator);
  m_effects = compiledEffects(m_options.effects, m_detected);
  Bvh tree = std::move(m_packed.bvh);
  m_packed = tree.nodes.empty() ? packScene(m_scene, estimator, m_effects)
                                : packScene(m_scene, estimator, m_effects, std::move(tree));
  learnScene(m_packed, m_scene, m_effects, estimator);
  m_integrator.reset(); // it is bound to what goes now
  m_device = uploadScene(m_context, m_packed);
  m_buildSeconds = watch.seconds();
}

void Stage::compile(const EstimatorSettings& estimator, Shader shader) {
  const Stopwatch watch;
  IntegratorSettings settings{estimator, m_scene.width, m_scene.height, m_options.seed, {}, {}};
  const bool primary = shader == Shader::BaseColour || shader == Shader::Normals;
  if (primary) {
    settings.shaders.path = spirv::kPrimary;
    settings.extraConstants[shared::kConstantPrimaryView] =
        shader == Shader::Normals ? shared::kPrimaryNormals : shared::kPrimaryBaseColour;
  }
  m_integrator = std::make_unique<Integrator>(m_context, m_device, m_scene,
                                              primary ? primaryEffects(m_effects) : m_effects, settings);
  m_integrator->warmUp();
  m_compileSeconds = watch.seconds();
}

void Stage::prepare(const ViewSettings& settings) {
  const EstimatorSettings estimator = settings.rendered();
  pack(estimator);
  compile(estimator, settings.shader);
}

void Stage::restart(const Camera& camera, Vec2i size) {
  const Camera before = m_scene.camera;
  m_scene.camera = camera;
  try {
    m_integrator->restart(m_scene, size.x, size.y);
  } catch (const UsageError&) {
    m_scene.camera = before;
    throw;
  }
}

} // namespace vkpt
