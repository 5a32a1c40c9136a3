// The mean of an image, and the size that an image is rendered at.

#include "selftest/film_mean.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

/// Two pixels: 1 and 3 by four samples each, of variance 2 and 8.
Film twoPixels() { return {2, 1, {{4, Vec3d(1.0), Vec3d(6.0)}, {4, Vec3d(3.0), Vec3d(24.0)}}}; }

TEST(FilmMean, GreyPixelsAreStrata) {
  const MeanEstimate mean = meanLuminance(twoPixels());
  EXPECT_DOUBLE_EQ(mean.mean, 2.0);
  // 2 / 4 and 8 / 4, over the square of two pixels: the difference between them is not counted.
  EXPECT_DOUBLE_EQ(mean.variance, (0.5 + 2.0) / 4.0);
  EXPECT_DOUBLE_EQ(mean.degrees, 2.5 * 2.5 / (0.5 * 0.5 / 3.0 + 2.0 * 2.0 / 3.0));
}

TEST(FilmMean, OfColoursIsTheirLuminance) {
  const Film film{1, 1, {{2, {1.0, 2.0, 3.0}, {2.0, 0.0, 0.0}}}};
  const MeanEstimate mean = meanLuminance(film);
  EXPECT_DOUBLE_EQ(mean.mean, 0.212671 + 2.0 * 0.715160 + 3.0 * 0.072169);
  EXPECT_DOUBLE_EQ(mean.variance, 0.212671 * 0.212671);
}

TEST(FilmMean, OfAnImageWithoutNoise) {
  const Film film{1, 1, {{100, Vec3d(0.5), Vec3d(0.0)}}};
  const MeanEstimate mean = meanLuminance(film);
  EXPECT_DOUBLE_EQ(mean.variance, kLeastSampleVariance / 100.0);
  EXPECT_EQ(mean.degrees, 99.0);
}

TEST(SizeForSamples, KeepsTheShape) {
  using Size = std::pair<int, int>;
  EXPECT_EQ(sizeForSamples(1, 1, 100000), Size(79, 79));
  EXPECT_EQ(sizeForSamples(1280, 720, 100000), Size(96, 54));
  EXPECT_EQ(sizeForSamples(512, 512, 100), Size(2, 2));
  EXPECT_EQ(sizeForSamples(1, 1, 2), Size(1, 1));
  EXPECT_EQ(sizeForSamples(31, 7, 100), Size(31, 7)) << "no smaller size has this shape";
}

} // namespace
} // namespace vkpt::test
