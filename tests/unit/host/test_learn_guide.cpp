// What is learned of a scene before a render.
#include "host/learn_guide.h"
#include "unit/host/boxes.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

CornellScene guidedSpheres() {
  CornellScene box = cornellBox("spheres", 16, 1);
  box.settings.estimator.lightTracing = LightTracing::On;
  box.settings.estimator.guiding = Guiding::Auto;
  return box;
}

/// The scene is packed once: that takes as long as to learn.
PackedScene learned(PackedScene packed, const CornellScene& box, const EffectSet& effects, unsigned threads) {
  learnGuide(packed, box.scene, effects, box.settings.estimator, threads);
  return packed;
}

TEST(LearnGuide, DoesNotDependOnThreads) {
  const CornellScene box = guidedSpheres();
  const EffectSet effects = detectEffects(box.scene, box.settings.estimator);
  const PackedScene packed = packScene(box.scene, box.settings.estimator, effects);
  const PackedScene one = learned(packed, box, effects, 1);
  EXPECT_NE(one.lightChoice.guide.edge, 0U);
  EXPECT_EQ(one.guide, learned(packed, box, effects, 3).guide);
}

/// Neither by option, nor where caustics are left out of the image, whatever is compiled in.
TEST(LearnGuide, LearnsNothingForAnImageWithoutIt) {
  CornellScene box = guidedSpheres();
  const PackedScene packed = packScene(box.scene, box.settings.estimator, EffectSet::all());
  const EstimatorSettings settings = box.settings.estimator;
  box.settings.estimator.guiding = Guiding::Off;
  EXPECT_EQ(learned(packed, box, EffectSet::all(), 1).lightChoice.guide.edge, 0U) << "off";
  box.settings.estimator = settings;
  box.settings.estimator.maxBounces = 2;
  EXPECT_EQ(learned(packed, box, EffectSet::all(), 1).lightChoice.guide.edge, 0U) << "two bounces";
}

} // namespace
} // namespace vkpt::test
