// The device against both host programs: the same paths, but for the few that rounding parts.

#include "host/learn_guide.h"
#include "scenes/made_scenes.h"
#include "scenes/render_fixture.h"
#include "scenes/statistics.h"
#include "unit/host/boxes.h"
#include "unit/host/image_difference.h"

namespace vkpt::test {
namespace {

constexpr int kSize = 64;
constexpr int kFrames = 16;

void expectParity(const Film& device, const HostRender& host, double partedPerSample) {
  EXPECT_EQ(host.counters.faults(), 0U);
  const PartedPaths limit = partedPaths(partedPerSample, kSize * kSize * kFrames);
  const ImageDifference d = differenceOf(device, host.film);
  EXPECT_LE(d.pixels, limit.most);
  EXPECT_LE(d.meanOverSe, limit.meanOverSe);
}

/// What the device renders as the host does.
RenderSetup setupOf(const HostSettings& host) {
  return {.estimator = host.estimator,
          .width = host.width,
          .height = host.height,
          .frames = kFrames,
          .seed = host.seed};
}

class DeviceParity : public RenderTest, public testing::WithParamInterface<BoxParity> {};
using SplatParity = RenderTest;
using TreeParity = RenderTest;
using ReuseParity = RenderTest;

TEST_P(DeviceParity, WalksThePathsOfTheHost) {
  const CornellScene box = cornellBox(GetParam().box, kSize, seed());
  const Film device = render(box.scene, setupOf(box.settings)).film;
  const auto host = [&](const auto& renderHost) {
    return renderHost(box.packed, box.scene, box.effects, box.settings, kFrames, 2);
  };
  expectParity(device, host(renderHost32), GetParam().partedInFloat);
  expectParity(device, host(renderHost64), GetParam().partedInDouble);
}

/// Paths from the lights as well, and several behind each specular surface, guided. A path that parts may
/// have brought splats to a few pixels.
TEST_F(SplatParity, BringsTheSplatsOfTheHost) {
  CornellScene box = cornellBox("spheres", kSize, seed());
  box.settings.estimator.lightTracing = LightTracing::On;
  box.settings.estimator.specularSamples = 2;
  box.settings.estimator.guiding = Guiding::Auto;
  box.effects = detectEffects(box.scene, box.settings.estimator);
  box.packed = packGuided(box.scene, box.settings.estimator, box.effects, 2);
  EXPECT_NE(box.packed.lightChoice.guide.edge, 0U);
  const Film device = render(box.scene, setupOf(box.settings)).film;
  EXPECT_TRUE(device.splatVarianceOfMean.has_value());
  const double parted = kBoxParities[1].partedInFloat * 8.0;
  expectParity(device, renderHost32(box.packed, box.scene, box.effects, box.settings, kFrames, 2), parted);
  const HostRender one = renderHost32(box.packed, box.scene, box.effects, box.settings, kFrames, 1);
  const HostRender two = renderHost32(box.packed, box.scene, box.effects, box.settings, kFrames, 2);
  EXPECT_TRUE(identical(one.film, two.film));
}

/// Lights of all kinds, chosen by the tree.
TEST_F(TreeParity, WalksThePathsOfTheHost) {
  const Scene scene = everything();
  HostSettings settings{misSampling(), kSize, kSize, seed()};
  settings.estimator.lightSelection = LightSelection::Tree;
  const EffectSet effects = detectEffects(scene, settings.estimator);
  EXPECT_TRUE(effects.has(Effect::LightTree));
  const PackedScene packed = packGuided(scene, settings.estimator, effects, 1);
  EXPECT_NE(packed.lightChoice.grid.edge, 0U);
  const Film device = render(scene, setupOf(settings)).film;
  expectParity(device, renderHost32(packed, scene, effects, settings, kFrames, 2),
               kBoxParities[1].partedInFloat * 2.0);
  expectParity(device, renderHost64(packed, scene, effects, settings, kFrames, 2),
               kBoxParities[1].partedInDouble * 2.0);
}

/// Pixels share paths: one that parts is seen by all that share it.
TEST_F(ReuseParity, SharesThePathsOfTheHost) {
  CornellScene box = cornellBox("spheres", kSize, seed());
  box.settings.estimator.lightTracing = LightTracing::On;
  box.settings.estimator.pathReuse = 16;
  box.effects = detectEffects(box.scene, box.settings.estimator);
  EXPECT_TRUE(box.effects.has(Effect::PathReuse));
  const Film device = render(box.scene, setupOf(box.settings)).film;
  expectParity(device, renderHost32(box.packed, box.scene, box.effects, box.settings, kFrames, 2),
               kBoxParities[1].partedInFloat * 16.0);
  expectParity(device, renderHost64(box.packed, box.scene, box.effects, box.settings, kFrames, 2),
               kBoxParities[1].partedInDouble * 16.0);
}

INSTANTIATE_TEST_SUITE_P(Boxes, DeviceParity, testing::ValuesIn(kBoxParities),
                         [](const auto& box) { return std::string(box.param.box); });

} // namespace
} // namespace vkpt::test
