#pragma once
// Runs the tests of a file: Student's t-tests and chi-squared tests as Nori's public framework defines them.

#include "scene/nori_tests.h"
#include "selftest/outcome.h"

#include <cstdint>

namespace vkpt {

/// Does a t-test of scenes, which takes a device: testSceneMeans(), where there is one. `seed` is its own.
using TestScenes = std::function<void(const NoriTTest& test, std::uint32_t seed, const TellOutcome& tell)>;

struct SelftestCounts {
  std::size_t passed = 0;
  std::size_t failed = 0;
};

/// Throws SceneError for a test that can't be done, before any is run. seed: of all random numbers.
SelftestCounts runTests(const NoriTests& tests, std::uint32_t seed, const TestScenes& testScenes,
                        const TellOutcome& tell);

} // namespace vkpt
