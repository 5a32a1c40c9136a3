#pragma once
// Renders a scene that a check made, on the shipped kernels or on a test build of them.

#include "film/film.h"
#include "render/render_loop.h"
#include "selftest/settings.h"

#include <memory>
#include <optional>
#include <string>

namespace vkpt::selftest {

using Spirv = std::span<const std::uint32_t>;

/// The kernels that a check runs on. The shipped ones; or, in tests, a build of them with a mistake switched
/// on (shaders/shared/mutations.h).
struct Kernel {
  std::uint32_t mutation = 0;
  /// The test build of a shipped shader, which has the switch as a specialisation constant.
  Spirv (*testBuild)(Spirv shipped) = nullptr;

  [[nodiscard]] Spirv of(Spirv shipped) const { return testBuild == nullptr ? shipped : testBuild(shipped); }
  [[nodiscard]] gpu::SpecialisationMap constants() const;
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
  std::vector<Fault> faults; ///< the first of them
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

Rendered renderScene(const gpu::Context& context, const Scene& scene, const RenderSetup& setup);

} // namespace vkpt::selftest
