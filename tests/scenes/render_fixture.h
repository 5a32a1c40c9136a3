#pragma once
// Rendering in tests: one validated context for the process, and what every render is checked for.

#include "film/film.h"
#include "selftest/render_scene.h"

#include <gtest/gtest.h>

namespace vkpt::test {

using namespace selftest;

/// Made at the first call, with the validation layer on.
const gpu::Context& sharedContext();

/// On the shared context.
Rendered renderScene(const Scene& scene, const RenderSetup& setup);

std::string currentTestName();

/// Writes the film as EXR and PNG into a folder named after the running test; returns where.
std::string savePicture(const Film& film, const std::string& name);

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
