#include "scenes/render_fixture.h"

#include "core/hash.h"
#include "film/image.h"
#include "scenes/test_shaders.h"

#include <algorithm>

namespace vkpt::test {

const gpu::Context& sharedContext() {
  static const gpu::Context context({"", true});
  return context;
}

namespace {

IntegratorSettings integratorSettings(const RenderSetup& setup) {
  IntegratorSettings s;
  s.estimator = setup.estimator;
  s.width = setup.width;
  s.height = setup.height;
  s.seed = setup.seed;
  if (setup.kernel.mutation != 0 || setup.kernel.testBuild) {
    s.pathShader = spirv::kMutablePath;
    s.extraConstants[kMutationConstant] = setup.kernel.mutation;
  }
  return s;
}

} // namespace

Studio::Studio(const gpu::Context& context, const Scene& scene, const RenderSetup& setup) : m_setup(setup) {
  const EffectSet effects = setup.effects.value_or(detectEffects(scene, setup.estimator));
  m_scene = uploadScene(context, packScene(scene, setup.estimator, effects, 1));
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
  return r;
}

Rendered renderScene(const Scene& scene, const RenderSetup& setup, const gpu::Context& context) {
  return Studio(context, scene, setup).render();
}

std::uint32_t seedOf(const std::string& name) {
  const std::uint64_t hash = hashText(name);
  return static_cast<std::uint32_t>(hash ^ (hash >> 32U));
}

std::string currentTestName() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return info == nullptr ? "none" : std::string(info->test_suite_name()) + "." + info->name();
}

std::string savePicture(const Film& film, const std::string& name) {
  std::string folderName = currentTestName();
  std::ranges::replace(folderName, '/', '-');
  const fs::path folder = fs::temp_directory_path() / "vkpt-tests" / folderName;
  fs::create_directories(folder);
  const fs::path stem = folder / name;
  for (const char* extension : {".exr", ".png"})
    writeImage(stem.string() + extension, develop(film), {}, {});
  return stem.string() + ".{exr,png}";
}

EffectSet everyEffect() { return EffectSet::all(); }

void RenderTest::SetUp() { m_messagesBefore = sharedContext().validationMessages(); }

void RenderTest::TearDown() {
  EXPECT_EQ(sharedContext().validationMessages(), m_messagesBefore)
      << "the validation layer spoke; see above";
  if (!HasFailure())
    return;
  for (std::size_t i = 0; i < m_pictures.size(); ++i)
    std::cout << "picture: " << savePicture(m_pictures[i], "render-" + std::to_string(i)) << '\n';
}

Rendered RenderTest::render(const Scene& scene, RenderSetup setup) {
  constexpr std::size_t kMostPictures = 8;
  if (setup.seed == 0)
    setup.seed = seed();
  Rendered r = renderScene(scene, setup);
  EXPECT_EQ(r.counters.faults(), 0U) << "nonFinite " << r.counters.nonFinite << ", cutTraversal "
                                     << r.counters.cutTraversal << ", stackOverflow "
                                     << r.counters.stackOverflow << ", invalidPdf " << r.counters.invalidPdf;
  if (m_pictures.size() < kMostPictures)
    m_pictures.push_back(r.film);
  return r;
}

} // namespace vkpt::test
