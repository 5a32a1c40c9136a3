// Each known mistake (shaders/shared/mutations.h) is noticed by a named check.
#include "scenes/check.h"
#include "scenes/statistics.h"
#include "scenes/test_shaders.h"

#include <iostream>

namespace vkpt::test {
namespace {

/// The check that must notice it: were the others to follow where it doesn't, it could go blind unnoticed.
struct Watch {
  Mutation mutation;
  const char* check;
};
constexpr Watch kWatches[] = {
    {Mutation::SurfaceCosineDropped, "litFloorByNee"},
    {Mutation::LightCosineDropped, "litFloorByNee"},
    {Mutation::InversePiDropped, "litFloorByNee"},
    {Mutation::DistanceNotSquared, "litFloorByNee"},
    {Mutation::SurvivalNotDivided, "m3-roulette-by-channel"},
    {Mutation::LightAreaDropped, "litFloorByNee"},
    {Mutation::LightChoiceDropped, "litFloorByNee"},
    {Mutation::AliasIgnored, "unequalLights"},
    {Mutation::EmissionTwice, "litFloorByNee"},
    {Mutation::BackEmits, "emitterBack"},
    {Mutation::BackSampled, "litFromBehind"},
    {Mutation::UniformHemisphere, "litFloorByBsdf"},
    {Mutation::TriangleWarp, "litFloorByNee"},
    {Mutation::AlwaysReflects, "d4-refraction"},
    {Mutation::NeverReflects, "d4-refraction"},
    {Mutation::FresnelOnePolarisation, "d4-refraction"},
    {Mutation::EtaInverted, "d4-refraction"},
    {Mutation::GlassAlwaysEntered, "d4-slab"},
    {Mutation::ConductorAbsorptionDropped, "d9-metal"},
    {Mutation::MirrorWeightDropped, "d9-mirror"},
    {Mutation::OcclusionIgnored, "shadowed"},
    {Mutation::OffsetDropped, "coincidentTwins"},
    {Mutation::OffsetInward, "litFloorByNee"},
    {Mutation::RouletteCapped, "m3-roulette-by-channel"},
    {Mutation::LightBlockReused, "lightAndBsdfIndependent"},
    {Mutation::NextLightBlockReused, "rouletteAndNextLightIndependent"},
    {Mutation::SampleIgnored, "samplesDiffer"},
    {Mutation::BounceLimitOffByOne, "furnaceByBounces"},
    {Mutation::BackgroundTwice, "backgroundOnly"},
    {Mutation::ThroughputDropped, "d9-mirror"},
    {Mutation::DirectThroughputDropped, "neeAgainstBsdf"},
    {Mutation::PixelNotJittered, "imageLayout"},
    {Mutation::ImageFlipped, "imageLayout"},
    {Mutation::CarriedEmitLost, "carriedPaths"},
    {Mutation::ReplicatesAlike, "sobolTellsItsError"},
    {Mutation::CarriedThroughputLost, "carriedPaths"},
    {Mutation::TooFewSamplesInMean, "filmOfSamples"},
    {Mutation::DeviationsFromOldMean, "filmOfSamples"},
    {Mutation::MergeMeanUnweighted, "mergedGroups"},
    {Mutation::MergeBetweenDropped, "mergedGroups"},
    {Mutation::MergeLowDropped, "mergedGroups"},
    {Mutation::MisWeightDropped, "litFloorByMis"},
    {Mutation::MisSamplesIgnored, "lightSamplesByMis"},
    {Mutation::LightSamplesNotAveraged, "lightSamplesAverage"},
    {Mutation::PhongNormalisation, "d10-phong-head-on"},
    {Mutation::BackScatters, "oneSided"},
    {Mutation::PointFalloffDropped, "pointLight"},
    {Mutation::EnvironmentAliasIgnored, "unequalTexels"},
    {Mutation::EnvironmentSineDropped, "unequalTexels"},
    {Mutation::TextureFlipped, "textured"},
    {Mutation::FilterSignDropped, "evenByFilter"},
    {Mutation::SplitUnweighted, "splitSlab"},
    {Mutation::BranchKeyShared, "branchesAreIndependent"},
    {Mutation::UnwantedKindsCount, "furnaceKinds"},
    {Mutation::TransmissionIsReflection, "lampInGlass"},
    {Mutation::CarriedBranchLost, "carriedBranches"},
    {Mutation::CarriedPdfLost, "carriedDensities"},
    {Mutation::CarriedHistoryLost, "carriedHistory"},
    {Mutation::CausticsTwice, "furnaceFromLights"},
    {Mutation::AxisCosineDropped, "lightIntoGlass"},
    {Mutation::ShadingAdjointDropped, "leaningMirror"},
    {Mutation::IndexAdjointDropped, "lightIntoGlass"},
    {Mutation::IrreversibleJoined, "smoothCausticsFromLights"},
    {Mutation::SplatCarryLost, "leaningMirror"},
    {Mutation::RepeatsAlike, "repeatsAreAllotted"},
    {Mutation::RepeatsNotAveraged, "repeatsAreAllotted"},
    {Mutation::AllottedUnweighted, "repeatsAreAllotted"},
    {Mutation::CarriedRepeatLost, "carriedFromLights"},
    {Mutation::TreeShareDropped, "lampsBelowTables"},
    {Mutation::TableShareDropped, "lampsByTree"},
    {Mutation::TableAliasIgnored, "lampsByTree"},
    {Mutation::TreeWeighedByPower, "glowByTree"},
    {Mutation::CarriedTableLost, "carriedByTree"},
    {Mutation::ReuseGeometryDropped, "cellsShared"},
    {Mutation::ReuseThroughWalls, "cellsShared"},
    {Mutation::ReuseBlockedCounts, "cellsShared"},
    {Mutation::ReuseWeighsByEye, "causticsShared"},
    {Mutation::CarriedReuseLost, "carriedShared"},
    {Mutation::GuideDensityDropped, "guidedByTheMirror"},
    {Mutation::GuideAliasIgnored, "guidedByTheMirror"},
    {Mutation::GuideWeighedByBoth, "furnaceByGuide"},
};

const Check& checkFor(Mutation mutation) {
  const auto* const watch = std::ranges::find(kWatches, mutation, &Watch::mutation);
  if (watch == std::ranges::end(kWatches))
    throw std::invalid_argument("no check watches for the mutation: list one in kWatches");
  return checkNamed(watch->check);
}

std::vector<std::string> failuresOf(const Check& check, const MutationInfo& mutation) {
  Trial trial(check.name, sharedContext(), mutatedKernel(static_cast<std::uint32_t>(mutation.mutation)));
  trial.run(check.run);
  return trial.failures();
}

class Mutations : public RenderTest, public testing::WithParamInterface<MutationInfo> {};

TEST_P(Mutations, IsNoticed) {
  const Check& check = checkFor(GetParam().mutation);
  const std::vector<std::string> failures = failuresOf(check, GetParam());
  ASSERT_FALSE(failures.empty()) << GetParam().name << " (" << GetParam().what << ") is not noticed by "
                                 << check.name;
  std::cout << GetParam().name << " (" << GetParam().what << ") is noticed by " << failures[0] << '\n';
}

INSTANTIATE_TEST_SUITE_P(Of, Mutations, testing::ValuesIn(kMutations),
                         [](const auto& test) { return std::string(test.param.name); });

/// The kernel that carries the switch is the shipped one while it is off.
TEST_F(RenderTest, TestBuildOfTheKernelIsTheShippedOne) {
  RenderSetup setup{.estimator = lightSampling(), .width = 32, .height = 32, .frames = 20};
  const Film shipped = render(twoLightRoom(), setup).film;
  setup.kernel = mutatedKernel(0);
  EXPECT_TRUE(identical(shipped, render(twoLightRoom(), setup).film));
}

} // namespace
} // namespace vkpt::test
