#pragma once
// Runs the tests of a file: Student's t-tests and chi-squared tests as Nori's public framework defines them.

#include "device/estimator_settings.h"
#include "gpu/context.h"
#include "scene/nori_tests.h"
#include "selftest/outcome.h"

#include <cstdint>

namespace vkpt {

/// How a scene of a test is to be rendered.
using EstimatorOf = std::function<EstimatorSettings(const Scene&)>;

struct SelftestSettings {
  std::uint32_t seed = 0; ///< of all random numbers
  EstimatorOf estimator;
  gpu::ContextOptions device; ///< opened only where a scene is to be rendered
};

struct SelftestCounts {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::uint64_t validationMessages = 0; ///< of the device's validation layer
};

/// Throws SceneError for a test that can't be done, before any is run.
SelftestCounts runTests(const NoriTests& tests, const SelftestSettings& settings, const TellOutcome& tell);

} // namespace vkpt
