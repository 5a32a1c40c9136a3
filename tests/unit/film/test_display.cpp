// From radiance to the bytes of a PNG, and back.

#include "decode/stb.h"
#include "film/codecs.h"
#include "film/display.h"
#include "unit/film/film_fixtures.h"

#include <cmath>
#include <limits>

namespace vkpt::test {
namespace {

constexpr float kInfinityF = std::numeric_limits<float>::infinity();

/// The red bytes of the PNG that a row of reds becomes.
std::vector<int> bytesOf(const std::vector<float>& reds, const DisplaySettings& display) {
  const TemporaryFolder folder;
  Image image(static_cast<int>(reds.size()), 1, {"R", "G", "B"});
  image.channels[0].values = reds;
  writeImage(folder / "x.png", image, display, {});
  const decode::Samples png = decode::stbDecode(film::readWholeFile(folder / "x.png"));
  std::vector<int> bytes;
  for (std::size_t i = 0; i < reds.size(); ++i) {
    bytes.push_back(png.rgb[3 * i] / 257);
    EXPECT_EQ(png.rgb[3 * i + 1], 0);
  }
  return bytes;
}

TEST(Display, EveryFloatHasAByte) {
  const std::vector<float> odd{std::nanf(""), -std::nanf(""), -1.0F,   -kInfinityF, -0.0F,
                               0.0F,          1.0F,           1.0001F, 3e38F,       kInfinityF};
  const std::vector<int> clipped{0, 0, 0, 0, 0, 0, 255, 255, 255, 255};
  EXPECT_EQ(bytesOf(odd, {.tonemap = Tonemap::None}), clipped);
  EXPECT_EQ(bytesOf(odd, {.tonemap = Tonemap::Srgb}), clipped);
  EXPECT_EQ(bytesOf(odd, {.exposureStops = 2000.0, .tonemap = Tonemap::None}), clipped); // 2^2000 is infinite
  const std::vector<int> aces = bytesOf(odd, {.tonemap = Tonemap::Aces});
  EXPECT_EQ((std::vector<int>{aces.begin(), aces.begin() + 6}), std::vector<int>(6, 0));
  EXPECT_EQ(aces[8], 255);
  EXPECT_EQ(aces[9], 255);
}

TEST(Display, LinearRoundsToNearest) {
  std::vector<float> reds;
  std::vector<int> expected;
  for (int i = 0; i < 255; ++i) {
    reds.push_back((static_cast<float>(i) + 0.499F) / 255.0F);
    expected.push_back(i);
    reds.push_back((static_cast<float>(i) + 0.501F) / 255.0F);
    expected.push_back(i + 1);
  }
  EXPECT_EQ(bytesOf(reds, {.tonemap = Tonemap::None}), expected);
}

/// Figures of IEC 61966-2-1, by hand: 12.92 x up to x = 0.0031308, then 1.055 x^(1/2.4) - 0.055; the two meet
/// there to within 3e-8 of the standard's rounded constants.
TEST(Display, SrgbCurve) {
  EXPECT_DOUBLE_EQ(film::srgbEncode(0.0031308), 12.92 * 0.0031308);
  EXPECT_DOUBLE_EQ(film::srgbEncode(0.001), 0.01292);
  EXPECT_NEAR(film::srgbEncode(std::nextafter(0.0031308, 1.0)), 12.92 * 0.0031308, 3e-8);
  EXPECT_NEAR(film::srgbEncode(0.18), 0.46135612950044164, 1e-15);
  EXPECT_NEAR(film::srgbEncode(0.5), 0.7353569830524495, 1e-15);
  EXPECT_NEAR(film::srgbEncode(1.0), 1.0, 1e-15);
  EXPECT_EQ(film::srgbEncode(0.0), 0.0);
  EXPECT_EQ(bytesOf({0.0031308F, 0.18F, 0.5F, 0.2158605F}, {}), (std::vector<int>{10, 118, 188, 128}));
  for (int i = 0; i <= 1000;
       ++i) // the two thresholds differ by 5e-8, where a value may take the other branch
    EXPECT_NEAR(film::srgbDecode(film::srgbEncode(i / 1000.0)), i / 1000.0, 1e-7);
}

TEST(Display, EveryByteComesBack) {
  const TemporaryFolder folder;
  Image image(256, 1, {"R", "G", "B"});
  for (int i = 0; i < 256; ++i)
    image.channels[1].values[static_cast<std::size_t>(i)] = static_cast<float>(film::srgbDecode(i / 255.0));
  writeImage(folder / "x.png", image, {}, {});
  const Image back = readImage(folder / "x.png");
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_EQ(back.channels[c].values, image.channels[c].values);
}

TEST(Display, ExposureIsInStops) {
  EXPECT_EQ(bytesOf({0.25F, 0.125F}, {.exposureStops = 1.0, .tonemap = Tonemap::None}),
            (std::vector<int>{128, 64}));
  EXPECT_EQ(bytesOf({1.0F, 2.0F}, {.exposureStops = -2.0, .tonemap = Tonemap::None}),
            (std::vector<int>{64, 128}));
  EXPECT_EQ(bytesOf({0.25F}, {.exposureStops = 1.0}), (std::vector<int>{188}));
}

/// The fit's figures by hand: at 0.18 (0.18 (2.51 0.18 + 0.03)) / (0.18 (2.43 0.18 + 0.59) + 0.14) =
/// 0.0867240 / 0.3249320; at 1 2.54 / 3.16.
TEST(Display, AcesCurve) {
  EXPECT_NEAR(film::acesFilmic(0.18), 0.0867240 / 0.3249320, 1e-12);
  EXPECT_NEAR(film::acesFilmic(1.0), 2.54 / 3.16, 1e-15);
  EXPECT_EQ(film::acesFilmic(0.0), 0.0);
  EXPECT_NEAR(film::acesFilmic(std::numeric_limits<double>::infinity()), 2.51 / 2.43, 1e-12);
  EXPECT_EQ(bytesOf({0.18F, 1.0F, 0.0F, 100.0F}, {.tonemap = Tonemap::Aces}),
            (std::vector<int>{141, 232, 0, 255}));
}

} // namespace
} // namespace vkpt::test
