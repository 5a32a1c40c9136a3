// Runs know their error, in a few seconds; test_calibration_long.cpp has more scenes.

#include "calibration/calibration_checks.h"

namespace vkpt::test {
namespace {

TEST(Calibration, OfTheCornellBox) { expectCalibrated(sceneOf("cornell", 48, 48), 24, 256); }

TEST(Calibration, OfSobolPoints) { expectCalibrated(sceneOf("cornell", 48, 48), 24, 256, Sampler::Sobol); }

TEST(TargetError, IsKeptInNineOfTenRuns) { expectTargetKept(sceneOf("cornell", 16, 16), 0.1, 40, 16384); }

TEST(Slope, IsThatOfIndependentSamples) {
  expectSlopeOfIndependentSamples(sceneOf("cornell", 16, 16), 8, 512, SlopeOver::frames);
}

} // namespace
} // namespace vkpt::test
