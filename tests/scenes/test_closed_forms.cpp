// Scenes whose radiance is known, beyond those of the named checks.
#include "scenes/check.h"
#include "scenes/statistics.h"

#include <cmath>

namespace vkpt::test {
namespace {

class ClosedForm : public RenderTest {
protected:
  /// As Trial::expectMean.
  static void expectMean(const Film& film, const Vec3d& expected, double tolerance) {
    Trial trial("mean", sharedContext());
    trial.expectMean(film, expected, tolerance);
    for (const std::string& failure : trial.failures())
      ADD_FAILURE() << failure;
  }
  static void expectConstant(const Film& film, const Vec3d& value, int operations) {
    Trial trial("constant", sharedContext());
    trial.expectConstant(film, value, operations, "value");
    for (const std::string& failure : trial.failures())
      ADD_FAILURE() << failure;
  }
};

/// Samples such that the furnace's standard error is a third of 0.5 %, with a tenth to spare: by either
/// roulette the sum of a path of albedo a has the relative variance a, up to its start.
std::uint64_t furnaceFrames(double albedo, int pixels) {
  const double error = 0.005 / 3.0 / 1.1;
  return static_cast<std::uint64_t>(std::ceil(albedo / (error * error) / pixels));
}

struct FurnaceCase {
  float albedo;
  RouletteMode roulette;
};
class Furnace : public ClosedForm, public testing::WithParamInterface<FurnaceCase> {};

TEST_P(Furnace, HasTheSeriesOfItsBounces) {
  const auto [albedo, roulette] = GetParam();
  constexpr int kEdge = 96;
  const Rendered r = render(furnace(Vec3f(albedo)), {.estimator = bsdfSampling(roulette),
                                                     .width = kEdge,
                                                     .height = kEdge,
                                                     .frames = furnaceFrames(double{albedo}, kEdge * kEdge)});
  expectMean(r.film, Vec3d(1.0 / (1.0 - double{albedo})), 0.005);
  EXPECT_EQ(r.counters.cappedPaths, 0U);
  if (albedo >= 0.99F) {
    EXPECT_GT(r.counters.carriedPaths, 0U) << "no path outlasted its dispatch";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Albedo, Furnace,
    testing::Values(FurnaceCase{0.5F, RouletteMode::Throughput}, FurnaceCase{0.9F, RouletteMode::Throughput},
                    FurnaceCase{0.99F, RouletteMode::Throughput}, FurnaceCase{0.5F, RouletteMode::Albedo},
                    FurnaceCase{0.9F, RouletteMode::Albedo}, FurnaceCase{0.99F, RouletteMode::Albedo}),
    [](const auto& test) {
      return std::to_string(static_cast<int>(std::lround(1000.0F * test.param.albedo))) + "Thousandths" +
             (test.param.roulette == RouletteMode::Albedo ? "ByAlbedo" : "ByThroughput");
    });

TEST_F(ClosedForm, FurnaceChannelsKeepTheirOwnSeries) {
  const Rendered r =
      render(furnace({0.2F, 0.5F, 0.95F}), {.estimator = bsdfSampling(RouletteMode::Throughput),
                                            .width = 96,
                                            .height = 96,
                                            .frames = furnaceFrames(0.95, 96 * 96)});
  expectMean(r.film, {1.25, 2.0, 20.0}, 0.006);
}

/// The floor's radiance depends on angles alone: the same at any scale and anywhere.
class Placement : public ClosedForm,
                  public testing::WithParamInterface<std::tuple<const char*, double, Vec3d, bool>> {};

TEST_P(Placement, LeavesIrradianceAlone) {
  const auto& [name, scale, offset, nee] = GetParam();
  const LitFloor lit = litFloor(scale, offset);
  const Rendered r = render(lit.scene, {.estimator = nee ? lightSampling() : bsdfSampling(),
                                        .width = 64,
                                        .height = 64,
                                        .frames = nee ? 40U : 160U});
  expectMean(r.film, lit.radiance, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Of, Placement,
                         testing::Values(std::tuple("TinyByNee", 1e-4, Vec3d(0.0), true),
                                         std::tuple("HugeByNee", 1e6, Vec3d(0.0), true),
                                         std::tuple("FarByNee", 1.0, Vec3d(131072.0, -65536.0, 131072.0),
                                                    true),
                                         std::tuple("TinyByBsdf", 1e-4, Vec3d(0.0), false),
                                         std::tuple("HugeByBsdf", 1e6, Vec3d(0.0), false)),
                         [](const auto& test) { return std::string(std::get<0>(test.param)); });

/// n = 1.5 in a cube: a diagonal ray meets every face beyond the critical angle, for ever, at throughput 1.
TEST_F(ClosedForm, TotalReflectionTrapsNoRender) {
  const Scene scene = SceneBuilder()
                          .box(Vec3d(-1.0), Vec3d(1.0), Facing::Outward, glass(1.5F))
                          .camera(lookAt({0.1, -0.2, 0.05}, {1.1, 0.8, 1.05}, 2.0))
                          .background(Vec3f(1.0F))
                          .build();
  const std::uint64_t frames = 2;
  const Rendered r = render(scene, {.width = 8, .height = 8, .frames = frames});
  EXPECT_EQ(r.counters.cappedPaths, 64 * frames);
  EXPECT_GT(r.counters.carriedPaths, 0U);
  expectConstant(r.film, Vec3d(0.0), 0);
}

/// Along the axis the same camera sees the background through the face, or through the one behind it.
TEST_F(ClosedForm, GlassCubeFromInsideShowsItsSurroundings) {
  const Scene scene = SceneBuilder()
                          .box(Vec3d(-1.0), Vec3d(1.0), Facing::Outward, glass(1.5F))
                          .camera(lookAt({0.1, -0.2, 0.05}, {0.1, -0.2, -1.0}, 20.0))
                          .background({0.5F, 1.0F, 2.0F})
                          .build();
  const Rendered r = render(scene, {.width = 16, .height = 16, .frames = 20});
  EXPECT_EQ(r.counters.cappedPaths, 0U);
  expectConstant(r.film, {0.5, 1.0, 2.0}, 0);
}

/// 1, 1000 and 1e6: an index that bends nothing, and ones that let almost nothing through.
TEST_F(ClosedForm, GlassOfAnyIndexKeepsWhiteWhite) {
  for (const float ior : {1.0F, 1.0001F, 2.4F, 1000.0F, 1e6F}) {
    SCOPED_TRACE(ior);
    const Scene scene = SceneBuilder()
                            .floor({0.0, 0.0, 0.0}, 1.0, glass(ior))
                            .ceiling({0.0, -0.3, 0.0}, 1.0, glass(ior))
                            .camera(lookAt({0.0, 0.4, 1.5}, {0.0, 0.0, 0.0}, 50.0))
                            .background(Vec3f(1.0F))
                            .build();
    expectConstant(render(scene, {.frames = 32}).film, Vec3d(1.0), 0);
  }
}

TEST_F(ClosedForm, DarkSceneIsBlack) {
  const Scene scene = SceneBuilder()
                          .box(Vec3d(-1.0), Vec3d(1.0), Facing::Inward, diffuse(Vec3f(0.0F)))
                          .camera(lookAt({0.0, 0.0, 0.5}, {0.0, 0.0, -1.0}, 60.0))
                          .build();
  for (const auto& effects : {std::optional<EffectSet>(), std::optional(everyEffect())})
    expectConstant(render(scene, {.effects = effects}).film, Vec3d(0.0), 0);
}

} // namespace
} // namespace vkpt::test
