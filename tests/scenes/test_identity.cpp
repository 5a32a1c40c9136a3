// Same seed, same bits, whatever the batch, the tiles, the threads and the image's shape; and other seeds,
// pixels and frames tell independent stories.
#include "scene/load.h"
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace vkpt::test {
namespace {

class Identity : public RenderTest {
protected:
  static RenderSetup spheresSetup() {
    return {.estimator = lightSampling(), .width = 50, .height = 35, .frames = 21, .seed = seed()};
  }
  static Scene spheres() {
    const fs::path path("cornell-spheres");
    SceneReport report;
    return loadScene({&path, 1}, report);
  }
};

TEST_F(Identity, BatchesChangeNothing) {
  RenderSetup setup = spheresSetup();
  const Scene scene = spheres();
  const Film whole = render(scene, setup).film;
  for (const std::uint32_t batch : {1U, 3U, 5U}) {
    setup.batch = batch;
    EXPECT_TRUE(identical(render(scene, setup).film, whole)) << "batch " << batch;
  }
}

/// Splats come from everywhere to everywhere.
TEST_F(Identity, BatchesAndTilesChangeNothingOfPathsFromTheLights) {
  RenderSetup setup = spheresSetup();
  setup.estimator.lightTracing = LightTracing::On;
  setup.estimator.specularSamples = 3;
  const Scene scene = spheres();
  const Film whole = render(scene, setup).film;
  EXPECT_TRUE(whole.splatVarianceOfMean.has_value());
  for (const auto& [batch, blocks] : {std::pair(1U, 0U), {5U, 0U}, {16U, 3U}}) {
    setup.batch = batch;
    setup.tileBlocks = blocks;
    EXPECT_TRUE(identical(render(scene, setup).film, whole))
        << "batch " << batch << ", " << blocks << " blocks a tile";
  }
}

/// Pixels share paths within their block alone, whole or cut off by the image's edge.
TEST_F(Identity, BatchesAndTilesChangeNothingOfSharedPaths) {
  RenderSetup setup = spheresSetup();
  setup.estimator.pathReuse = 16;
  setup.estimator.lightTracing = LightTracing::On;
  setup.estimator.specularSamples = 2;
  const Scene scene = spheres();
  const Film whole = render(scene, setup).film;
  for (const auto& [batch, blocks] : {std::pair(1U, 0U), {5U, 0U}, {16U, 3U}, {16U, 4096U}}) {
    setup.batch = batch;
    setup.tileBlocks = blocks;
    EXPECT_TRUE(identical(render(scene, setup).film, whole))
        << "batch " << batch << ", " << blocks << " blocks a tile";
  }
}

TEST_F(Identity, TilesChangeNothing) {
  RenderSetup setup = spheresSetup();
  const Scene scene = spheres();
  const Film measured = render(scene, setup).film;
  for (const std::uint32_t blocks : {1U, 7U, 64U, 4096U}) {
    setup.tileBlocks = blocks;
    EXPECT_TRUE(identical(render(scene, setup).film, measured)) << blocks << " blocks a tile";
  }
}

/// With all that a path carries from one dispatch to the next, and the images of the kinds beside the whole.
TEST_F(Identity, BatchesAndTilesChangeNothingInVariety) {
  Scene scene = variety();
  scene.filter.shape = PixelFilter::Shape::Tent;
  scene.filter.radius = 1.0;
  EstimatorSettings settings = misSampling();
  settings.splitDepth = 5;
  settings.lightSamples = 2;
  settings.lightSelection = LightSelection::Tree;
  settings.kindImages = true;
  RenderSetup setup{.estimator = settings, .width = 50, .height = 35, .frames = 21, .seed = seed()};
  Studio whole(sharedContext(), scene, setup);
  const Rendered first = whole.render();
  EXPECT_GT(first.counters.carriedPaths, 0U);
  for (const auto& [batch, blocks] : {std::pair(1U, 0U), {5U, 0U}, {16U, 3U}}) {
    setup.batch = batch;
    setup.tileBlocks = blocks;
    Studio other(sharedContext(), scene, setup);
    const Film film = other.render().film;
    EXPECT_TRUE(identical(film, first.film)) << "batch " << batch << ", " << blocks << " blocks a tile";
    EXPECT_EQ(other.integrator().kindImages(film), whole.integrator().kindImages(first.film));
  }
}

std::ptrdiff_t threadsOfProcess() {
  return std::distance(fs::directory_iterator("/proc/self/task"), fs::directory_iterator());
}

/// llvmpipe reads LP_NUM_THREADS when a device is looked for.
TEST_F(Identity, ThreadsChangeNothing) {
  if (!sharedContext().info().name.starts_with("llvmpipe"))
    GTEST_SKIP() << "the device is not llvmpipe: its threads are its own affair";
  const Scene scene = spheres();
  const gpu::ContextOptions validated{"", true};
  const char* const before = std::getenv("LP_NUM_THREADS");
  const std::string saved = before == nullptr ? "" : before;
  std::vector<Film> films;
  std::vector<std::ptrdiff_t> threads;
  std::vector<std::unique_ptr<gpu::Context>> contexts; // kept: a thread that is still ending would be counted
  for (const char* count : {"1", "2", "3"}) {
    setenv("LP_NUM_THREADS", count, 1);
    const std::ptrdiff_t others = threadsOfProcess();
    const gpu::Context& context = *contexts.emplace_back(std::make_unique<gpu::Context>(validated));
    threads.push_back(threadsOfProcess() - others);
    films.push_back(renderScene(context, scene, spheresSetup()).film);
    EXPECT_EQ(context.validationMessages(), 0U);
  }
  if (saved.empty())
    unsetenv("LP_NUM_THREADS");
  else
    setenv("LP_NUM_THREADS", saved.c_str(), 1);
  EXPECT_GT(threads[1], threads[0]) << "LP_NUM_THREADS had no effect: nothing was tested";
  EXPECT_GT(threads[2], threads[1]);
  EXPECT_TRUE(identical(films[0], films[1]));
  EXPECT_TRUE(identical(films[0], films[2]));
}

/// Nothing is read or written beyond a buffer.
TEST_F(Identity, RobustBufferAccessChangesNothing) {
  gpu::ContextOptions robust{"", true};
  robust.robustBufferAccess = true;
  const gpu::Context context(robust);
  const Film film = renderScene(context, spheres(), spheresSetup()).film;
  EXPECT_EQ(context.validationMessages(), 0U);
  EXPECT_TRUE(identical(film, render(spheres(), spheresSetup()).film));
}

TEST_F(Identity, RunsInPiecesChangeNothing) {
  RenderSetup setup = spheresSetup();
  const Scene scene = spheres();
  const Film whole = render(scene, setup).film;
  Studio studio(sharedContext(), scene, setup);
  Integrator& integrator = studio.integrator();
  const std::uint32_t half = integrator.blockCount() / 2;
  const Tile halves[] = {{0, half}, {half, integrator.blockCount() - half}};
  for (const std::uint32_t first : {0U, 9U, 16U}) {
    const std::uint32_t count = first == 0 ? 9 : (first == 9 ? 7 : 5);
    for (const Tile& tile : halves)
      integrator.renderTile(tile, first, count);
  }
  EXPECT_TRUE(identical(integrator.film(), whole));
  EXPECT_TRUE(identical(studio.render().film, whole)) << "a cleared film is not as good as new";
}

class ImageShape : public Identity, public testing::WithParamInterface<std::pair<int, int>> {};

TEST_P(ImageShape, EveryPixelGetsItsSamples) {
  const auto [width, height] = GetParam();
  const Rendered r = render(furnace(Vec3f(0.5F)), {.estimator = withBounces(bsdfSampling(), 1),
                                                   .width = width,
                                                   .height = height,
                                                   .frames = 19,
                                                   .batch = 5,
                                                   .tileBlocks = 3});
  ASSERT_EQ(r.film.pixels.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const PixelMoments& p : r.film.pixels) {
    ASSERT_EQ(p.count, 19U);
    ASSERT_EQ(p.mean, Vec3d(1.5));
    ASSERT_EQ(p.m2, Vec3d(0.0));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ImageShape,
                         testing::Values(std::pair(1, 1), std::pair(17, 1), std::pair(1, 23),
                                         std::pair(129, 77), std::pair(2048, 3)),
                         [](const auto& test) {
                           return std::to_string(test.param.first) + "x" + std::to_string(test.param.second);
                         });

/// Values of independent, identically distributed samples, one a pixel: a furnace looks the same everywhere.
class Independence : public RenderTest {
protected:
  static constexpr int kEdge = 128;
  using Values = std::vector<double>;

  Values samples(std::uint32_t seed) { return valuesOf(render(scene(), setup(seed)).film); }
  static Scene scene() { return furnace(Vec3f(0.8F)); }
  static RenderSetup setup(std::uint32_t seed) {
    return {.estimator = bsdfSampling(RouletteMode::Albedo),
            .width = kEdge,
            .height = kEdge,
            .frames = 1,
            .seed = seed};
  }
  static Values valuesOf(const Film& film) {
    Values v;
    for (const PixelMoments& p : film.pixels)
      v.push_back(p.mean.x);
    return v;
  }
  /// Of each pixel with the one (dx, dy) further on.
  static double lagged(const Values& v, int dx, int dy) {
    Values a;
    Values b;
    for (int y = 0; y + dy < kEdge; ++y) {
      for (int x = 0; x + dx < kEdge; ++x) {
        a.push_back(v[static_cast<std::size_t>(y * kEdge + x)]);
        b.push_back(v[static_cast<std::size_t>((y + dy) * kEdge + x + dx)]);
      }
    }
    return correlation(a, b);
  }
  /// |r| of n independent pairs has a standard deviation of 1 / sqrt(n).
  static constexpr double kBound = 4.5 / kEdge;
};

TEST_F(Independence, OfNeighbouringPixels) {
  const Values v = samples(seed());
  for (const auto& [dx, dy] : {std::pair(1, 0), {0, 1}, {1, 1}, {2, 0}, {0, 2}, {8, 0}, {0, 8}, {64, 0}})
    EXPECT_LT(std::abs(lagged(v, dx, dy)), kBound * 1.1) << "lag " << dx << ", " << dy;
}

TEST_F(Independence, OfSeeds) {
  const std::uint32_t first = seed();
  const Values v = samples(first);
  for (const std::uint32_t other : {first + 1, first ^ 0x80000000U, first ^ 0x9E3779B9U}) {
    const Values w = samples(other);
    EXPECT_NE(v, w);
    EXPECT_LT(std::abs(correlation(v, w)), kBound) << "seeds " << first << " and " << other;
  }
}

/// Also far apart: 2^32 frames on the low half of the sample's index is the same.
TEST_F(Independence, OfFrames) {
  Studio studio(sharedContext(), scene(), setup(seed()));
  const auto frame = [&](std::uint64_t index) {
    studio.integrator().clear();
    studio.integrator().renderTile({0, studio.integrator().blockCount()}, index, 1);
    return valuesOf(studio.integrator().film());
  };
  const Values v = frame(0);
  for (const std::uint64_t other :
       {std::uint64_t{16}, std::uint64_t{1} << 20U, std::uint64_t{1} << 32U, std::uint64_t{1} << 33U}) {
    const Values w = frame(other);
    EXPECT_NE(v, w) << "frame " << other;
    EXPECT_LT(std::abs(correlation(v, w)), kBound) << "frames 0 and " << other;
  }
}

/// Half the samples of an image are half its information: the standard error that many short runs show is the
/// one that each of them reports.
TEST_F(Independence, StandardErrorIsHonest) {
  constexpr int kRuns = 48;
  RenderSetup run = setup(0);
  run.width = run.height = 8;
  run.frames = 16;
  Vec3d reported(0.0);
  std::vector<double> means;
  for (int i = 0; i < kRuns; ++i) {
    run.seed = seed() + static_cast<std::uint32_t>(i);
    const Estimate e = estimateOf(render(scene(), run).film);
    reported += e.variance / static_cast<double>(kRuns);
    means.push_back(e.mean.x);
  }
  double mean = 0.0;
  for (const double m : means)
    mean += m / kRuns;
  double observed = 0.0;
  for (const double m : means)
    observed += (m - mean) * (m - mean) / (kRuns - 1);
  // The ratio times 47 is chi-squared with 47 degrees of freedom: 18.8 and 90.5 leave out 1e-4 at either end.
  std::cout << "observed / reported variance of the mean: " << observed / reported.x << '\n';
  EXPECT_GT(observed / reported.x, 18.8 / (kRuns - 1));
  EXPECT_LT(observed / reported.x, 90.5 / (kRuns - 1));
}

} // namespace
} // namespace vkpt::test
