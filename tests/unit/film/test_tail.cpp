// Hill's estimate of the samples' tail, on films of known distributions.
#include "film/tail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vkpt {
namespace {

constexpr int kEdge = 128;

/// A film of `frames` samples a pixel, each drawn by sample(x, y, random).
template<class Sample>
Film filmOf(int frames, const Sample& sample) {
  std::mt19937_64 random(std::hash<std::string>{}(
      testing::UnitTest::GetInstance()->current_test_info()->name())); // NOLINT: seeded by the test's name
  Film film{kEdge, kEdge, std::vector<PixelMoments>(static_cast<std::size_t>(kEdge) * kEdge)};
  for (int y = 0; y < kEdge; ++y) {
    for (int x = 0; x < kEdge; ++x) {
      PixelMoments& p = film.pixels[static_cast<std::size_t>(y) * kEdge + static_cast<std::size_t>(x)];
      for (int i = 0; i < frames; ++i)
        p.merge({1, Vec3d(sample(x, y, random)), Vec3d(0.0)});
    }
  }
  return film;
}

double uniform(std::mt19937_64& random) { return 1.0 - std::uniform_real_distribution<double>()(random); }
double pareto(std::mt19937_64& random, double index) { return std::pow(uniform(random), -1.0 / index); }

TEST(Tail, IndexOfAParetoDistributionIsFound) {
  for (const double index : {1.2, 1.6, 3.0}) {
    const auto tail = estimateTail(filmOf(64, [&](int, int, auto& random) { return pareto(random, index); }));
    ASSERT_TRUE(tail);
    // Sums of 64 reach their tail slowly, hence a wider bound than the standard error's.
    EXPECT_NEAR(tail->index, index, 4.0 * tail->standardError + 0.15 * index);
    EXPECT_EQ(tail->heavy(), index < 2.0) << tail->index;
  }
}

TEST(Tail, BoundedSamplesAreNotHeavy) {
  const auto flat = estimateTail(filmOf(64, [](int, int, auto& random) { return uniform(random); }));
  ASSERT_TRUE(flat);
  EXPECT_FALSE(flat->heavy()) << flat->index;
  const auto rare = estimateTail(
      filmOf(64, [](int, int, auto& random) { return uniform(random) < 0.02 ? 40.0 : uniform(random); }));
  ASSERT_TRUE(rare);
  EXPECT_FALSE(rare->heavy()) << rare->index;
}

TEST(Tail, EdgesAreNotHeavy) {
  const auto lamp = [](int x, int y, auto& random) {
    const bool edge = (x == 50 || x == 80 || y == 40 || y == 60) && x >= 50 && x <= 80 && y >= 40 && y <= 60;
    const double share = edge ? 0.5 : (x > 50 && x < 80 && y > 40 && y < 60 ? 1.0 : 0.0);
    return uniform(random) <= share ? 40.0 : 0.5 * uniform(random);
  };
  const auto tail = estimateTail(filmOf(32, lamp));
  ASSERT_TRUE(tail);
  EXPECT_FALSE(tail->heavy()) << tail->index;
}

TEST(Tail, FirefliesAreHeavy) {
  const auto rare = [](int, int, auto& random) {
    return uniform(random) < 2e-6 * 16 ? 1e4 * pareto(random, 1.0) : uniform(random);
  };
  const auto tail = estimateTail(filmOf(64, rare));
  ASSERT_TRUE(tail);
  EXPECT_TRUE(tail->heavy()) << tail->index;
}

TEST(Tail, IsNotEstimatedFromTooLittle) {
  EXPECT_FALSE(estimateTail(Film{}));
  EXPECT_FALSE(estimateTail(Film{8, 8, std::vector<PixelMoments>(64)}));
  EXPECT_FALSE(estimateTail(filmOf(1, [](int, int, auto& random) { return uniform(random); })));
  EXPECT_FALSE(estimateTail(filmOf(16, [](int, int, auto&) { return 3.0; })));
}

} // namespace
} // namespace vkpt
