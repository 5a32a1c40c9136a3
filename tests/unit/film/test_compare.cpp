// Metrics against values worked out by hand.

#include "film/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vkpt {
namespace {

/// Grey pixels in a row.
Image grey(std::initializer_list<float> values) {
  Image image(static_cast<int>(values.size()), 1, {"R", "G", "B"});
  for (auto& channel : image.channels)
    channel.values = values;
  return image;
}

void setErrors(Image& image, float value) {
  for (const char* name : {"stderr.R", "stderr.G", "stderr.B"})
    image.addChannel(name).values.assign(image.pixelCount(), value);
}

TEST(Compare, IdenticalImagesDoNotDiffer) {
  const Image image = grey({0.0F, 0.5F, 3.0F});
  const ImageDifference d = compareImages(image, image);
  EXPECT_EQ(d.mse, 0.0);
  EXPECT_EQ(d.rmse, 0.0);
  EXPECT_EQ(d.relMse, 0.0);
  EXPECT_EQ(d.psnr, std::numeric_limits<double>::infinity());
  EXPECT_EQ(d.meanDifference, Vec3d(0.0));
  EXPECT_EQ(d.pixels, 3U);
  EXPECT_EQ(d.nonFinite, 0U);
}

TEST(Compare, TwoPixelsByHand) {
  // a - b = 0.5 and -1; b = 1 and 4, m = 2.5, (0.01 m)^2 = 6.25e-4
  const ImageDifference d = compareImages(grey({1.5F, 3.0F}), grey({1.0F, 4.0F}));
  EXPECT_DOUBLE_EQ(d.mse, (0.25 + 1.0) / 2.0);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(0.625));
  EXPECT_DOUBLE_EQ(d.relMse, (0.25 / (1.0 + 6.25e-4) + 1.0 / (16.0 + 6.25e-4)) / 2.0);
  EXPECT_DOUBLE_EQ(d.psnr, 10.0 * std::log10(16.0 / 0.625));
  EXPECT_EQ(d.meanDifference, Vec3d(-0.25));
  EXPECT_FALSE(d.z());
}

TEST(Compare, ChannelsCountAlike) {
  Image image = grey({1.0F});
  image.channels[1].values[0] = 4.0F;
  const ImageDifference d = compareImages(image, grey({1.0F}));
  EXPECT_DOUBLE_EQ(d.mse, 9.0 / 3.0);
  EXPECT_EQ(d.meanDifference, Vec3d(0.0, 3.0, 0.0));
}

TEST(Compare, AConstantOffset) {
  const ImageDifference d = compareImages(grey({1.25F, 2.25F, 0.25F}), grey({1.0F, 2.0F, 0.0F}));
  EXPECT_DOUBLE_EQ(d.mse, 0.0625);
  EXPECT_EQ(d.meanDifference, Vec3d(0.25));
  // the black pixel counts by the floor, (0.01 * 1)^2
  EXPECT_DOUBLE_EQ(d.relMse, 0.0625 * (1.0 / 1.0001 + 1.0 / 4.0001 + 1.0 / 1e-4) / 3.0);
}

TEST(Compare, BlackAgainstBlackIsNoError) {
  EXPECT_EQ(compareImages(grey({0.0F}), grey({0.0F})).relMse, 0.0);
  EXPECT_EQ(compareImages(grey({1.0F}), grey({0.0F})).relMse, std::numeric_limits<double>::infinity());
}

TEST(Compare, ZIsTheMeanDifferenceOverItsStandardError) {
  Image image = grey({1.5F, 2.5F, 3.5F, 4.5F});
  Image reference = grey({1.0F, 2.0F, 3.0F, 4.0F});
  setErrors(image, 0.3F);
  // one image's errors: sqrt(4 * 0.09) / 4 = 0.15
  EXPECT_NEAR(*compareImages(image, reference).z(), 0.5 / 0.15, 1e-6);
  setErrors(reference, 0.4F); // both: sqrt(4 * 0.25) / 4 = 0.25
  EXPECT_NEAR(*compareImages(image, reference).z(), 0.5 / 0.25, 1e-6);
  EXPECT_NEAR(*compareImages(reference, image).z(), -0.5 / 0.25, 1e-6);
}

TEST(Compare, ZIsOfTheChannelThatIsFarthest) {
  Image image = grey({1.0F});
  image.channels[1].values[0] = 0.0F;
  setErrors(image, 0.5F);
  EXPECT_NEAR(*compareImages(image, grey({1.0F})).z(), -2.0, 1e-6);
}

TEST(Compare, NoZFromErrorsThatAreNotKnown) {
  Image image = grey({1.0F, 2.0F});
  setErrors(image, 0.0F);
  EXPECT_FALSE(compareImages(image, grey({1.0F, 2.0F})).z());
}

TEST(Compare, PixelsThatAreNotFiniteAreLeftOutAndCounted) {
  Image image = grey({1.5F, NAN, 2.0F});
  const Image reference = grey({1.0F, 7.0F, INFINITY});
  setErrors(image, 0.25F);
  const ImageDifference d = compareImages(image, reference);
  EXPECT_EQ(d.pixels, 1U);
  EXPECT_EQ(d.nonFinite, 2U);
  EXPECT_DOUBLE_EQ(d.mse, 0.25);
  EXPECT_DOUBLE_EQ(d.relMse, 0.25 / 1.0001); // the mean is of the one pixel
  EXPECT_NEAR(*d.z(), 2.0, 1e-6);
}

TEST(DifferencePicture, IsLogarithmicFromOneInAThousand) {
  // the floor (0.01 m)^2 with m = 1000 is below a hundredth of b^2
  const Image reference = grey({1000.0F, 1000.0F, 1000.0F, 1000.0F, NAN});
  const Image picture = differencePicture(grey({1000.0F, 1001.0F, 1031.6228F, 3000.0F, 1.0F}), reference);
  const auto expectColour = [&](std::size_t pixel, const Vec3d& colour) {
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(picture.channels[c].values[pixel], colour[static_cast<int>(c)], 1e-3) << pixel;
  };
  expectColour(0, magma(0.0));
  expectColour(1, magma(0.0));
  expectColour(2, magma(0.5)); // 10^-1.5
  expectColour(3, magma(1.0));
  expectColour(4, {0.0, 1.0, 0.0});
}

TEST(Magma, IsMatplotlibsTable) {
  struct Row {
    double t;
    Vec3d colour;
  };
  // rows 0, 64, 128, 192 and 255 of matplotlib's _cm_listed.py
  for (const Row& row :
       {Row{0.0, {0.001462, 0.000466, 0.013866}}, Row{64.0 / 255, {0.316654, 0.07169, 0.48538}},
        Row{128.0 / 255, {0.716387, 0.214982, 0.47529}}, Row{192.0 / 255, {0.9867, 0.535582, 0.38221}},
        Row{1.0, {0.987053, 0.991438, 0.749504}}}) {
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(magma(row.t)[c], row.colour[c], 0.02) << row.t << " channel " << c;
  }
}

} // namespace
} // namespace vkpt
