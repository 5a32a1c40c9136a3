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

PackedScene learned(const CornellScene& box, const EffectSet& effects, unsigned threads) {
  return packGuided(box.scene, box.settings.estimator, effects, threads);
}

TEST(LearnGuide, DoesNotDependOnThreads) {
  const CornellScene box = guidedSpheres();
  const EffectSet effects = detectEffects(box.scene, box.settings.estimator);
  const PackedScene one = learned(box, effects, 1);
  EXPECT_NE(one.lightChoice.guide.edge, 0U);
  EXPECT_EQ(one.guide, learned(box, effects, 3).guide);
}

/// Neither by option, nor where caustics are left out of the image, whatever is compiled in.
TEST(LearnGuide, LearnsNothingForAnImageWithoutIt) {
  for (int i = 0; i < 2; ++i) {
    CornellScene box = guidedSpheres();
    if (i == 0)
      box.settings.estimator.guiding = Guiding::Off;
    else
      box.settings.estimator.maxBounces = 2;
    EXPECT_EQ(learned(box, EffectSet::all(), 1).lightChoice.guide.edge, 0U) << i;
  }
}

} // namespace
} // namespace vkpt::test
