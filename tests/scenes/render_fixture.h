#pragma once
// Rendering in tests: one validated context for the process, and what every render is checked for.

#include "film/film.h"
#include "render/render_loop.h"
#include "scenes/made_scenes.h"

#include <gtest/gtest.h>

#include <optional>

namespace vkpt::test {

/// Made at the first call, with the validation layer on.
const gpu::Context& sharedContext();

/// The kernels that a test runs: 0 the shipped ones; else the test build of them with this mutation
/// (shaders/shared/mutations.h) switched on.
struct Kernel {
  std::uint32_t mutation = 0;
  bool testBuild = false; ///< the test build even where no mutation is switched on
};

struct RenderSetup {
  EstimatorSettings estimator{};
  int width = 16;
  int height = 16;
  std::uint64_t frames = 16;
  std::uint32_t seed = 0;
  std::uint32_t batch = shared::kSamplesPerGroup;
  std::uint32_t tileBlocks = 0;
  std::optional<EffectSet> effects{}; ///< empty: those that the scene calls for
  Kernel kernel{};
};

struct Rendered {
  Film film;
  RunCounters counters;
};

/// A scene on the device, ready to render more than once.
class Studio {
public:
  Studio(const gpu::Context& context, const Scene& scene, const RenderSetup& setup);
  /// Renders setup.frames frames into an empty film.
  [[nodiscard]] Rendered render();
  [[nodiscard]] Integrator& integrator() { return *m_integrator; }

private:
  RenderSetup m_setup;
  DeviceScene m_scene;
  std::unique_ptr<Integrator> m_integrator;
};

Rendered renderScene(const Scene& scene, const RenderSetup& setup,
                     const gpu::Context& context = sharedContext());

/// Hash of a name: the seed of a test, or of one of several renders in it.
std::uint32_t seedOf(const std::string& name);
std::string currentTestName();

/// Writes the film as EXR and PNG into a folder named after the running test; returns where.
std::string savePicture(const Film& film, const std::string& name);

/// Every effect there is, whatever the scene calls for.
EffectSet everyEffect();

/// Fails when the validation layer has said anything during the test.
class RenderTest : public testing::Test {
protected:
  void SetUp() override;
  void TearDown() override;
  /// Renders with the test's seed; zero faults are demanded. The picture is kept for the case of failure.
  Rendered render(const Scene& scene, RenderSetup setup);
  [[nodiscard]] static std::uint32_t seed() { return seedOf(currentTestName()); }

private:
  std::uint64_t m_messagesBefore = 0;
  std::vector<Film> m_pictures;
};

} // namespace vkpt::test
