// Runs know their error, in a few seconds; test_calibration_long.cpp has more scenes.

#include "calibration/calibration_checks.h"

namespace vkpt::test {
namespace {

constexpr EstimatorSettings kWithLights{
    .sampler = Sampler::Sobol, .lightTracing = LightTracing::On, .specularSamples = 4};

TEST(Calibration, OfTheCornellBox) { expectCalibrated(sceneOf("cornell", 32, 32), 24, 256); }

TEST(Calibration, OfSobolPoints) {
  expectCalibrated(sceneOf("cornell", 32, 32), 24, 256, {.sampler = Sampler::Sobol});
}

TEST(Calibration, OfPathsFromTheLights) {
  expectCalibrated(sceneOf("cornell-spheres", 10, 10), 16, 2048, kWithLights);
}

TEST(TargetError, IsKeptInNineOfTenRuns) { expectTargetKept(sceneOf("cornell", 16, 16), 0.1, 40, 16384); }

TEST(Slope, IsThatOfIndependentSamples) {
  expectSlopeOfIndependentSamples(sceneOf("cornell", 16, 16), 8, 512, SlopeOver::frames);
}

} // namespace
} // namespace vkpt::test
