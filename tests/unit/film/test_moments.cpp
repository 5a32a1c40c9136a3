// Merging moments: exact where it can be, and as accurate as the algorithm's bound where it cannot.

#include "unit/film/film_fixtures.h"

#include <cmath>

namespace vkpt::test {
namespace {

PixelMoments sample(double x) { return {1, Vec3d(x), Vec3d(0.0)}; }

PixelMoments sequential(const std::vector<double>& samples, std::size_t begin, std::size_t end) {
  PixelMoments m;
  for (std::size_t i = begin; i < end; ++i)
    m.merge(sample(samples[i]));
  return m;
}

/// Merged in batches of random size from 0 on.
PixelMoments batched(const std::vector<double>& samples, std::size_t largest, std::mt19937_64& random) {
  PixelMoments m;
  for (std::size_t begin = 0; begin < samples.size();) {
    const std::size_t end = std::min(samples.size(), begin + random() % (largest + 1));
    m.merge(sequential(samples, begin, end));
    begin = end;
  }
  return m;
}

/// Merged pairwise, halves of halves.
PixelMoments pairwise(const std::vector<double>& samples, std::size_t begin, std::size_t end) {
  if (end - begin < 2)
    return sequential(samples, begin, end);
  PixelMoments m = pairwise(samples, begin, begin + (end - begin) / 2);
  m.merge(pairwise(samples, begin + (end - begin) / 2, end));
  return m;
}

TEST(Moments, AConstantHasNoVarianceAtAll) {
  auto random = randomOfTest();
  for (const double c : {0.0, -0.0, 0.1, 1.0 / 3.0, -7.3, 1e6 + 0.1, 1e-300, 3e38}) {
    const std::vector<double> samples(1000, c);
    for (const PixelMoments& m :
         {sequential(samples, 0, 1000), batched(samples, 17, random), pairwise(samples, 0, 1000)}) {
      EXPECT_EQ(m.count, 1000U);
      EXPECT_EQ(m.mean, Vec3d(c));
      EXPECT_EQ(m.m2, Vec3d(0.0)) << c;
      EXPECT_EQ(m.varianceOfMean(), Vec3d(0.0));
    }
  }
}

TEST(Moments, AnEmptySetChangesNothing) {
  const PixelMoments some{7, {0.1, -2.5, 1e200}, {0.3, 1e-9, 4.0}};
  PixelMoments m = some;
  m.merge({});
  EXPECT_EQ(m.count, some.count);
  EXPECT_EQ(m.mean, some.mean);
  EXPECT_EQ(m.m2, some.m2);
  PixelMoments n;
  n.merge(some);
  EXPECT_EQ(n.count, some.count);
  EXPECT_EQ(n.mean, some.mean);
  EXPECT_EQ(n.m2, some.m2);
  n = {};
  n.merge({});
  EXPECT_EQ(n.count, 0U);
  EXPECT_EQ(n.mean, Vec3d(0.0));
  EXPECT_EQ(n.m2, Vec3d(0.0));
}

/// The bounds of Chan, Golub, LeVeque 1983, "Algorithms for computing the sample variance", table 1, for
/// updating algorithms: relative error of m2 at most n eps kappa, kappa = sqrt(1 + mean^2 n / m2); of the
/// mean n eps. A sum of squares would have kappa^2, which at mean 1e6 and deviation 1 leaves not a digit.
void expectMoments(const PixelMoments& m, const std::vector<double>& samples, const char* how) {
  const Direct d = directMoments(samples);
  const auto n = static_cast<long double>(samples.size());
  const long double eps = std::numeric_limits<double>::epsilon();
  const long double kappa = std::sqrt(1.0L + d.mean * d.mean * n / d.m2);
  ASSERT_EQ(m.count, samples.size());
  for (int c = 0; c < 3; ++c) {
    EXPECT_LE(std::abs(m.m2[c] - d.m2), n * eps * kappa * d.m2)
        << how << ", mean " << static_cast<double>(d.mean);
    long double size = 0.0L;
    for (const double x : samples)
      size = std::max(size, std::abs(static_cast<long double>(x)));
    EXPECT_LE(std::abs(m.mean[c] - d.mean), n * eps * size) << how;
  }
}

TEST(Moments, AnyOrderOfMergesGivesTheMomentsOfAllSamples) {
  auto random = randomOfTest();
  for (const double offset : {0.0, 1.0, -1e3, 1e6}) {
    for (const std::size_t count : {2UL, 3UL, 100UL, 10000UL}) {
      std::normal_distribution<double> normal(offset, 1.0);
      std::vector<double> samples(count);
      for (double& x : samples)
        x = normal(random);
      expectMoments(sequential(samples, 0, count), samples, "one by one");
      expectMoments(pairwise(samples, 0, count), samples, "pairwise");
      for (const std::size_t largest : {1UL, 16UL, 1000UL})
        expectMoments(batched(samples, largest, random), samples, "in batches");
    }
  }
}

TEST(Moments, ChannelsStayApart) {
  PixelMoments m{1, {1.0, 10.0, -4.0}, Vec3d(0.0)};
  m.merge({1, {3.0, 10.0, 2.0}, Vec3d(0.0)});
  EXPECT_EQ(m.mean, Vec3d(2.0, 10.0, -1.0));
  EXPECT_EQ(m.m2, Vec3d(2.0, 0.0, 18.0));
}

TEST(Moments, SquaresAreNeverNegative) {
  auto random = randomOfTest();
  std::uniform_real_distribution<double> exponent(-30.0, 30.0), sign(-1.0, 1.0);
  for (int round = 0; round < 2000; ++round) {
    PixelMoments m;
    const double base = std::pow(10.0, exponent(random));
    for (int merges = 0; merges < 30; ++merges) {
      const double x = merges % 3 == 0 ? sign(random) * std::pow(10.0, exponent(random)) : base;
      m.merge({1 + random() % 1000, Vec3d(x), Vec3d(merges % 5 == 0 ? base * base : 0.0)});
      for (int c = 0; c < 3; ++c) {
        ASSERT_GE(m.m2[c], 0.0);
        ASSERT_GE(m.varianceOfMean()[c], 0.0);
      }
    }
  }
}

TEST(Moments, VarianceOfTheMean) {
  const std::vector<double> samples{1.0, 2.0, 3.0, 4.0};
  EXPECT_DOUBLE_EQ(sequential(samples, 0, 4).varianceOfMean().y, 5.0 / 12.0);
  EXPECT_EQ(sequential(samples, 0, 1).varianceOfMean(), Vec3d(0.0));
  EXPECT_EQ(PixelMoments{}.varianceOfMean(), Vec3d(0.0));
}

TEST(Moments, CountsBeyond32Bits) {
  const std::uint64_t many = 1ULL << 40U;
  PixelMoments m{many, Vec3d(1.0), Vec3d(static_cast<double>(many))};
  m.merge({many, Vec3d(3.0), Vec3d(static_cast<double>(many))});
  EXPECT_EQ(m.count, 2 * many);
  EXPECT_EQ(m.mean, Vec3d(2.0));
  EXPECT_DOUBLE_EQ(m.m2.x, 4.0 * static_cast<double>(many));
  EXPECT_DOUBLE_EQ(m.varianceOfMean().x, 2.0 / static_cast<double>(2 * many - 1));
}

} // namespace
} // namespace vkpt::test
