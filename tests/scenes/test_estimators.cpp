// Estimators of one integral agree: light sampling and BSDF sampling, roulette of either kind and none, the
// effects a scene calls for and all of them.
#include "scene/load.h"
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <cmath>
#include <iostream>

namespace vkpt::test {
namespace {

constexpr int kEdge = 64;

Scene builtin(const char* name) {
  const fs::path path(name);
  SceneReport report;
  return loadScene({&path, 1}, report);
}

class Estimators : public RenderTest {
protected:
  /// Whole image per channel, and tile by tile: Welch's z below Šidák's bound of the family. `tolerance`: the
  /// relative bias of the whole image that would show, three of its standard errors.
  static void expectAgreement(const Film& a, const Film& b, double tolerance) {
    const Estimate ea = estimateOf(a);
    const Estimate eb = estimateOf(b);
    const Vec3d z = welch(ea, eb);
    const std::vector<Estimate> ta = tileEstimates(a);
    const std::vector<Estimate> tb = tileEstimates(b);
    double worst = 0.0;
    for (std::size_t i = 0; i < ta.size(); ++i)
      worst = std::max(worst, maxAbs(welch(ta[i], tb[i])));
    std::cout << "z of the image " << z.x << ' ' << z.y << ' ' << z.z << "; largest |z| of a tile " << worst
              << '\n';
    EXPECT_LT(maxAbs(z), sidakBound(3));
    EXPECT_LT(worst, sidakBound(3 * ta.size()));
    for (int c = 0; c < 3; ++c)
      EXPECT_LT(std::sqrt(ea.variance[c] + eb.variance[c]), tolerance / 3.0 * eb.mean[c]) << "too noisy";
  }

  Film renderWith(const Scene& scene, const EstimatorSettings& settings, std::uint64_t frames) {
    ++m_renders;
    const std::uint32_t seed = seedOf(currentTestName() + std::to_string(m_renders));
    return render(scene,
                  {.estimator = settings, .width = kEdge, .height = kEdge, .frames = frames, .seed = seed})
        .film;
  }

private:
  int m_renders = 0;
};

TEST_F(Estimators, LightAndBsdfSamplingAgreeOnTheBlocks) {
  const Scene scene = builtin("cornell");
  expectAgreement(renderWith(scene, lightSampling(), 128), renderWith(scene, bsdfSampling(), 1024), 0.02);
}

TEST_F(Estimators, LightAndBsdfSamplingAgreeOnTheSpheres) {
  const Scene scene = builtin("cornell-spheres");
  expectAgreement(renderWith(scene, lightSampling(), 256), renderWith(scene, bsdfSampling(), 1024), 0.02);
}

TEST_F(Estimators, MisAndSplittingAgreeOnTheSpheres) {
  const Scene scene = builtin("cornell-spheres");
  const Film byLights = renderWith(scene, lightSampling(), 256);
  expectAgreement(renderWith(scene, misSampling(), 256), byLights, 0.02);
  EstimatorSettings splitting = misSampling();
  splitting.splitDepth = 4;
  expectAgreement(renderWith(scene, splitting, 192), byLights, 0.02);
}

TEST_F(Estimators, RouletteModesAgree) {
  // Nearly grey: survival by the channels' mean gives a colour far above it (the box's red wall) an infinite
  // variance, and then no test of means holds.
  const Scene scene = twoLightRoom();
  EstimatorSettings albedo = lightSampling();
  albedo.roulette = RouletteMode::Albedo;
  EstimatorSettings late = lightSampling();
  late.rouletteAfter = 24; // a path of the room that long carries next to nothing
  const Film byThroughput = renderWith(scene, lightSampling(), 256);
  expectAgreement(renderWith(scene, albedo, 256), byThroughput, 0.02);
  expectAgreement(renderWith(scene, late, 64), byThroughput, 0.02);
}

TEST_F(Estimators, BounceLimitsAgree) {
  const Scene scene = builtin("cornell");
  for (const std::uint32_t bounces : {1U, 2U}) {
    SCOPED_TRACE(bounces);
    expectAgreement(renderWith(scene, withBounces(lightSampling(), bounces), 64),
                    renderWith(scene, withBounces(bsdfSampling(), bounces), 512), 0.03);
  }
}

/// The specialised kernel walks the same paths as the one with everything in it: the same numbers, but for
/// the order in which a compiler rounds them, and paths that such a difference sends elsewhere.
class Effects : public RenderTest, public testing::WithParamInterface<const char*> {};

TEST_P(Effects, LeftOutChangeNothing) {
  const Scene scene = builtin(GetParam());
  RenderSetup setup{.estimator = lightSampling(), .width = kEdge, .height = kEdge, .frames = 16};
  const Film detected = render(scene, setup).film;
  setup.effects = everyEffect();
  const Film all = render(scene, setup).film;
  std::size_t different = 0;
  for (std::size_t i = 0; i < all.pixels.size(); ++i) {
    const Vec3d a = detected.pixels[i].mean;
    const Vec3d b = all.pixels[i].mean;
    different += maxAbs(a - b) > 1e-5 * maxAbs(b) ? 1U : 0U;
  }
  std::cout << different << " of " << all.pixels.size() << " pixels differ; "
            << (identical(detected, all) ? "identical" : "not identical") << '\n';
  EXPECT_LE(different, all.pixels.size() / 200);
  EXPECT_LT(maxAbs(welch(estimateOf(detected), estimateOf(all))), 1.0); // paired: far below independent noise
}

INSTANTIATE_TEST_SUITE_P(Of, Effects, testing::Values("cornell", "cornell-spheres"), [](const auto& test) {
  return std::string(test.param) == "cornell" ? "TheBlocks" : "TheSpheres";
});

TEST_F(Estimators, EffectsLeftOutChangeNothingUnderASky) {
  const Scene scene = SceneBuilder()
                          .floor({0.0, 0.0, 0.0}, 2.0, diffuse({0.6F, 0.5F, 0.4F}))
                          .box({-0.5, 0.1, -0.5}, {0.5, 0.9, 0.5}, Facing::Outward, glass(1.5F))
                          .camera(lookAt({2.0, 1.5, 2.5}, {0.0, 0.3, 0.0}, 50.0))
                          .background({0.3F, 0.5F, 0.9F})
                          .build();
  RenderSetup setup{.estimator = lightSampling(), .width = 32, .height = 32, .frames = 64};
  const Film detected = render(scene, setup).film;
  setup.effects = everyEffect();
  EXPECT_LT(maxAbs(welch(estimateOf(detected), estimateOf(render(scene, setup).film))), 1.0);
}

/// All of it: every material, every light, kinds, splitting, light samples, a filter.
TEST_F(Estimators, EffectsLeftOutChangeNothingInVariety) {
  Scene scene = variety();
  scene.filter.shape = PixelFilter::Shape::Gaussian;
  scene.filter.radius = 1.5;
  EstimatorSettings settings = misSampling();
  settings.splitDepth = 2;
  settings.lightSamples = 2;
  settings.pathKinds = kAllPathKinds & ~1U;
  for (const LightStrategy light : {LightStrategy::Mis, LightStrategy::Nee}) {
    settings.light = light;
    RenderSetup setup{.estimator = settings, .width = 32, .height = 32, .frames = 32};
    const Film detected = render(scene, setup).film;
    setup.effects = everyEffect();
    EXPECT_LT(maxAbs(welch(estimateOf(detected), estimateOf(render(scene, setup).film))), 1.0);
  }
}

} // namespace
} // namespace vkpt::test
