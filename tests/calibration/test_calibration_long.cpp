// Runs know their error: three scenes, minutes each.

#include "calibration/calibration_checks.h"

namespace vkpt::test {
namespace {

constexpr std::uint32_t kSeeds = 64;

TEST(CalibrationLong, OfTheBlocks) { expectCalibrated(sceneOf("cornell", 32, 32), kSeeds, 512); }
TEST(CalibrationLong, OfTheSpheres) { expectCalibrated(sceneOf("cornell-spheres", 32, 32), kSeeds, 2048); }
TEST(CalibrationLong, OfTheBoxLitFromTheSide) { expectCalibrated(sceneOf("cbox.xml", 32, 32), kSeeds, 512); }

TEST(CalibrationLong, OfTheBlocksBySobol) {
  expectCalibrated(sceneOf("cornell", 32, 32), kSeeds, 512, {.sampler = Sampler::Sobol});
}
TEST(CalibrationLong, OfTheSpheresBySobol) {
  expectCalibrated(sceneOf("cornell-spheres", 32, 32), kSeeds, 2048, {.sampler = Sampler::Sobol});
}
TEST(CalibrationLong, OfTheBoxLitFromTheSideBySobol) {
  expectCalibrated(sceneOf("cbox.xml", 32, 32), kSeeds, 512, {.sampler = Sampler::Sobol});
}

TEST(CalibrationLong, OfTheSpheresWithPathsFromTheLights) {
  expectCalibrated(sceneOf("cornell-spheres", 32, 32), kSeeds, 2048,
                   {.sampler = Sampler::Sobol, .lightTracing = LightTracing::On, .specularSamples = 4});
}

TEST(TargetErrorLong, IsKeptOnTheBlocks) { expectTargetKept(sceneOf("cornell", 32, 32), 0.1, 100, 16384); }
TEST(TargetErrorLong, IsKeptOnTheSpheres) {
  expectTargetKept(sceneOf("cornell-spheres", 32, 32), 0.2, 100, 16384);
}

TEST(TargetErrorLong, IsKeptOnTheBlocksBySobol) {
  expectTargetKept(sceneOf("cornell", 32, 32), 0.1, 100, 16384, {.sampler = Sampler::Sobol});
}

TEST(SlopeLong, IsThatOfIndependentSamples) {
  expectSlopeOfIndependentSamples(sceneOf("cornell", 64, 64), 16, 256, SlopeOver::framesAndTime);
}

} // namespace
} // namespace vkpt::test
