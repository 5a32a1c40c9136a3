#include "selftest/render_scene.h"

#include "host/learn_guide.h"
#include "spirv.h"

namespace vkpt::selftest {
namespace {

constexpr std::uint32_t kMutationConstant = 127; // constant_id of kMutation

IntegratorSettings integratorSettings(const RenderSetup& setup) {
  IntegratorSettings s;
  s.estimator = setup.estimator;
  s.width = setup.width;
  s.height = setup.height;
  s.seed = setup.seed;
  s.shaders = {setup.kernel.of(spirv::kPath),
               {setup.kernel.of(spirv::kFirstVertices), setup.kernel.of(spirv::kSharePaths)}};
  s.extraConstants = setup.kernel.constants();
  return s;
}

} // namespace

gpu::SpecialisationMap Kernel::constants() const {
  return testBuild == nullptr ? gpu::SpecialisationMap{}
                              : gpu::SpecialisationMap{{kMutationConstant, mutation}};
}

Studio::Studio(const gpu::Context& context, const Scene& scene, const RenderSetup& setup) : m_setup(setup) {
  const EffectSet effects = setup.effects.value_or(detectEffects(scene, setup.estimator));
  m_scene = uploadScene(context, packGuided(scene, setup.estimator, effects, 1));
  m_integrator = std::make_unique<Integrator>(context, m_scene, scene, effects, integratorSettings(setup));
}

Rendered Studio::render() {
  RenderJob job;
  job.frames = m_setup.frames;
  job.batch = m_setup.batch;
  job.tileBlocks = m_setup.tileBlocks;
  RenderObserver observer;
  Rendered r;
  m_integrator->clear();
  renderUntil(*m_integrator, r.film, job, observer);
  r.counters = m_integrator->counters();
  r.faults = m_integrator->faults();
  return r;
}

Rendered renderScene(const gpu::Context& context, const Scene& scene, const RenderSetup& setup) {
  return Studio(context, scene, setup).render();
}

} // namespace vkpt::selftest
