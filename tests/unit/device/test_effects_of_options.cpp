// Effects that the options call for, and what depends on what.
#include "device/effects.h"
#include "scenes/made_scenes.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

EffectSet with(const EstimatorSettings& settings) { return detectEffects(variety(), settings); }

constexpr auto kSampling = {Effect::LightSampling, Effect::ManyLights, Effect::DeltaLights};

TEST(EffectsOfOptions, WithoutBouncesNothingScatters) {
  const EffectSet set = with(withBounces(misSampling(), 0));
  for (const Effect e :
       {Effect::Diffuse, Effect::Mirror, Effect::Glass, Effect::Phong, Effect::Textures, Effect::OneSided,
        Effect::LightSampling, Effect::Mis, Effect::Roulette, Effect::BounceLimit})
    EXPECT_FALSE(set.has(e)) << effectName(e);
  EXPECT_TRUE(set.has(Effect::AreaLights));
  EXPECT_TRUE(set.has(Effect::Environment));
  EXPECT_TRUE(set.has(Effect::Absorption)) << "the eye may be in the glass";
  EXPECT_TRUE(with(withBounces(misSampling(), 1)).has(Effect::BounceLimit));
  EXPECT_FALSE(with(misSampling()).has(Effect::BounceLimit));
}

TEST(EffectsOfOptions, RouletteBehindTheLimitNeverComes) {
  EstimatorSettings settings = withBounces(misSampling(), 2); // roulette: after 3
  EXPECT_FALSE(with(settings).has(Effect::Roulette));
  settings.maxBounces = 3;
  EXPECT_TRUE(with(settings).has(Effect::Roulette));
  settings.rouletteAfter = 4;
  EXPECT_FALSE(with(settings).has(Effect::Roulette));
}

TEST(EffectsOfOptions, TheStrategyDecidesWhatIsSampled) {
  EXPECT_TRUE(with(misSampling()).has(Effect::Mis));
  EXPECT_FALSE(with(lightSampling()).has(Effect::Mis));
  EXPECT_TRUE(with(lightSampling()).has(Effect::LightSampling));
  const EffectSet bsdf = with(bsdfSampling());
  EXPECT_TRUE(bsdf.has(Effect::LightSampling)) << "lights that no ray hits";
  EXPECT_FALSE(bsdf.has(Effect::Mis));
  Scene scene = variety();
  scene.pointLights.clear();
  scene.directionalLights.clear();
  EXPECT_FALSE(detectEffects(scene, bsdfSampling()).has(Effect::LightSampling));
}

TEST(EffectsOfOptions, SeveralLightSamplesAndSplittingNeedSomethingToActOn) {
  EstimatorSettings settings = misSampling();
  settings.lightSamples = 2;
  settings.splitDepth = 2;
  EXPECT_TRUE(with(settings).has(Effect::LightSamples));
  EXPECT_TRUE(with(settings).has(Effect::Splitting));
  const Scene plain = SceneBuilder().floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F))).build();
  EXPECT_FALSE(detectEffects(plain, settings).has(Effect::LightSamples)) << "no light";
  EXPECT_FALSE(detectEffects(plain, settings).has(Effect::Splitting)) << "nothing specular";
  EXPECT_FALSE(with(misSampling()).has(Effect::LightSamples));
  EXPECT_FALSE(with(misSampling()).has(Effect::Splitting));
}

TEST(EffectsOfOptions, KindsAndFilters) {
  EstimatorSettings settings = misSampling();
  EXPECT_FALSE(with(settings).has(Effect::PathKinds));
  settings.pathKinds = kAllPathKinds & ~2U;
  EXPECT_TRUE(with(settings).has(Effect::PathKinds));
  EXPECT_FALSE(with(settings).has(Effect::KindImages));
  settings = misSampling();
  settings.kindImages = true;
  EXPECT_TRUE(with(settings).has(Effect::PathKinds));
  EXPECT_TRUE(with(settings).has(Effect::KindImages));
  Scene scene = variety();
  EXPECT_FALSE(detectEffects(scene, {}).has(Effect::PixelFilter));
  scene.filter.radius = 1.0; // a wider box is no box of one pixel
  EXPECT_TRUE(detectEffects(scene, {}).has(Effect::PixelFilter));
}

TEST(LeavingOut, TakesAwayWhatMeansNothingWithoutIt) {
  const EffectSet set = with(misSampling());
  const EffectSet rest = without(set, EffectSet::of(Effect::LightSampling));
  for (const Effect e : kSampling) {
    EXPECT_TRUE(set.has(e)) << effectName(e);
    EXPECT_FALSE(rest.has(e)) << effectName(e);
  }
  EXPECT_FALSE(rest.has(Effect::Mis)) << "else emission would be weighed against samples that nobody takes";
  EXPECT_TRUE(rest.has(Effect::AreaLights));
  EXPECT_TRUE(without(set, EffectSet::of(Effect::Mis)).has(Effect::LightSampling));
}

TEST(LeavingOut, FacetsWithoutADistributionAreNone) {
  EffectSet both;
  for (const Effect e : {Effect::RoughMetal, Effect::Ggx, Effect::Beckmann})
    both.set(e);
  EXPECT_TRUE(without(both, EffectSet::of(Effect::Ggx)).has(Effect::RoughMetal)) << "the other one is there";
  EffectSet one = both;
  one.set(Effect::Beckmann, false);
  EXPECT_EQ(without(one, EffectSet::of(Effect::Ggx)), EffectSet());
}

} // namespace
} // namespace vkpt::test
