// The film's arithmetic in float, as the device does it. Literals are float here unless suffixed.

#include "host/program32.h"
#include "unit/host/mesh_scene.h"
#include "unit/host/random.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace vkpt::host32 {
namespace {

using Library = Program<RuntimeEffects>;
using Pair = Library::Pair;

struct FilmArithmetic : testing::Test {
  PackedScene scene = test::oneTriangle();
  Library lib{scene, FrameConstants{}, EffectSet{}, RouletteMode::Throughput};
  test::Random random;

  /// 24 random bits times 2^-exponents..2^exponents, of either sign.
  float number(int exponents) {
    const auto mantissa = static_cast<float>(random.between(-1, 1));
    return std::ldexp(mantissa,
                      static_cast<int>(random.bits() % static_cast<unsigned>(2 * exponents + 1)) - exponents);
  }
  Pair pair(int exponents) {
    return lib.quickTwoSum(number(exponents), std::ldexp(number(4), -exponents - 30));
  }
};

long double value(const Pair& p) {
  return static_cast<long double>(p.high) + static_cast<long double>(p.low);
}
double asDouble(float x) { return static_cast<double>(x); }

TEST_F(FilmArithmetic, SumsAndProductsAreExact) {
  for (int i = 0; i < 1'000'000; ++i) {
    const float a = number(14); // sums of these have at most 53 bits
    const float b = number(14);
    const Pair sum = lib.twoSum(a, b);
    ASSERT_EQ(asDouble(sum.high) + asDouble(sum.low), asDouble(a) + asDouble(b));
    ASSERT_EQ(sum.high, a + b);
    const Pair product = lib.twoProduct(a, b);
    ASSERT_EQ(asDouble(product.high) + asDouble(product.low), asDouble(a) * asDouble(b));
    ASSERT_EQ(product.high, a * b);
    const Pair quick = std::abs(a) >= std::abs(b) ? lib.quickTwoSum(a, b) : lib.quickTwoSum(b, a);
    ASSERT_EQ(asDouble(quick.high) + asDouble(quick.low), asDouble(a) + asDouble(b));
  }
}

TEST_F(FilmArithmetic, PairsKeep44Bits) {
  const long double tolerance = 0x1p-44L;
  long double worstSum = 0;
  long double worstProduct = 0;
  long double worstQuotient = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const Pair a = pair(8);
    const Pair b = pair(8);
    if (a.high == 0 || b.high == 0)
      continue;
    const long double scale = std::abs(value(a)) + std::abs(value(b)); // a difference may cancel
    worstSum = std::max(worstSum, std::abs(value(lib.addPairs(a, b)) - (value(a) + value(b))) / scale);
    const long double product = value(a) * value(b);
    worstProduct = std::max(worstProduct, std::abs(value(lib.multiplyPairs(a, b)) / product - 1));
    const long double quotient = value(a) / value(b);
    worstQuotient = std::max(worstQuotient, std::abs(value(lib.dividePairs(a, b)) / quotient - 1));
  }
  EXPECT_LT(worstSum, tolerance);
  EXPECT_LT(worstProduct, tolerance);
  EXPECT_LT(worstQuotient, tolerance);
}

TEST_F(FilmArithmetic, CountsAreExact) {
  for (int i = 0; i < 100'000; ++i) {
    const std::uint32_t n = i == 0 ? 0xFFFFFFFFU : random.bits();
    const Pair p = lib.pairFromCount(n);
    ASSERT_EQ(asDouble(p.high) + asDouble(p.low), static_cast<double>(n));
  }
}

TEST_F(FilmArithmetic, AMillionGroupsMergeWithoutStalling) {
  constexpr std::uint32_t kGroups = 1U << 20U;
  constexpr std::uint32_t kPerGroup = shared::kSamplesPerGroup;
  Pair mean{0, 0};
  Pair deviations{0, 0};
  long double sum = 0;
  long double within = 0;
  long double squares = 0; // of the means, about 1
  for (std::uint32_t g = 0; g < kGroups; ++g) {
    const auto groupMean = static_cast<float>(random.between(0, 2));
    const auto groupDeviations = static_cast<float>(random.between(0, 8));
    lib.mergeGroup(mean, deviations, g * kPerGroup, groupMean, groupDeviations, kPerGroup);
    sum += static_cast<long double>(groupMean);
    squares += (static_cast<long double>(groupMean) - 1) * (static_cast<long double>(groupMean) - 1);
    within += static_cast<long double>(groupDeviations);
  }
  const long double expectedMean = sum / kGroups;
  const long double spread = squares - (expectedMean - 1) * (expectedMean - 1) * kGroups;
  const long double expected = within + spread * kPerGroup;
  // Each merge rounds to a pair's 48 bits; of n independent errors, the k-th weighs k / n in the end: their
  // root mean square is sqrt(n / 3) 2^-48, 2e-12 for a million.
  const long double tolerance = 4.5L * std::sqrt(static_cast<long double>(kGroups) / 3) * 0x1p-48L;
  EXPECT_LT(std::abs(value(mean) / expectedMean - 1), tolerance);
  EXPECT_LT(std::abs(value(deviations) / expected - 1), tolerance);
}

TEST_F(FilmArithmetic, AConstantHasNoVariance) {
  for (int i = 0; i < 1000; ++i) {
    const float constant = std::abs(number(20));
    Pair mean{0, 0};
    Pair deviations{0, 0};
    std::uint32_t count = 0;
    for (int group = 0; group < 100; ++group) {
      Vec3 m(0);
      Vec3 d(0);
      for (std::uint32_t n = 1; n <= shared::kSamplesPerGroup; ++n)
        lib.addSample(m, d, static_cast<float>(n), Vec3(constant));
      lib.mergeGroup(mean, deviations, count, m.x, d.x, shared::kSamplesPerGroup);
      count += shared::kSamplesPerGroup;
    }
    ASSERT_EQ(mean.high, constant);
    ASSERT_EQ(mean.low, 0);
    ASSERT_EQ(deviations.high, 0);
    ASSERT_EQ(deviations.low, 0);
  }
}

TEST_F(FilmArithmetic, MergedDeviationsAreNeverNegative) {
  for (int i = 0; i < 20'000; ++i) {
    Pair mean{0, 0};
    Pair deviations{0, 0};
    const float base = std::abs(number(20));
    for (std::uint32_t g = 0; g < 32; ++g) { // means that hardly differ
      const float m = base * (1 + static_cast<float>(random.bits() % 3) * kEpsilon);
      lib.mergeGroup(mean, deviations, g * shared::kSamplesPerGroup, m, 0, shared::kSamplesPerGroup);
      ASSERT_GE(value(deviations), 0);
    }
  }
}

TEST_F(FilmArithmetic, AGroupHasTheMomentsOfItsSamples) {
  for (int i = 0; i < 10'000; ++i) {
    Vec3 mean(0);
    Vec3 deviations(0);
    std::array<double, shared::kSamplesPerGroup> samples{};
    double sum = 0;
    for (std::uint32_t n = 0; n < samples.size(); ++n) {
      const auto sample = static_cast<float>(random.between(0, 4));
      samples[n] = asDouble(sample);
      sum += samples[n];
      lib.addSample(mean, deviations, static_cast<float>(n + 1), Vec3(sample));
    }
    const double expectedMean = sum / samples.size();
    double expected = 0;
    for (const double s : samples)
      expected += (s - expectedMean) * (s - expectedMean);
    // Each of 16 updates rounds values up to 4, and squares of them.
    ASSERT_NEAR(asDouble(mean.y), expectedMean, 16 * 4 * asDouble(kEpsilon));
    ASSERT_NEAR(asDouble(deviations.y), expected, 16 * 2 * 16 * asDouble(kEpsilon));
  }
}

TEST_F(FilmArithmetic, DeviationsOfAGroupAreNeverNegative) {
  for (int i = 0; i < 1'000'000; ++i) {
    Vec3 mean(0);
    Vec3 deviations(0);
    const float base = number(10);
    for (std::uint32_t n = 1; n <= shared::kSamplesPerGroup; ++n) {
      // Anything; nearly equal numbers; mostly 0 with a few bright ones.
      const Vec3 sample(number(10), base * (1 + static_cast<float>(random.bits() % 5) * kEpsilon),
                        random.bits() % 8 == 0 ? number(20) : Float(0));
      lib.addSample(mean, deviations, static_cast<float>(n), sample);
    }
    ASSERT_GE(deviations.x, 0);
    ASSERT_GE(deviations.y, 0);
    ASSERT_GE(deviations.z, 0);
  }
}

} // namespace
} // namespace vkpt::host32
