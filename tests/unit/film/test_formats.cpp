// What is written is what is read, as far as a format can hold it.

#include "unit/film/film_fixtures.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <locale>

namespace vkpt::test {
namespace {

std::vector<std::uint32_t> bitsOf(const std::vector<float>& values) {
  std::vector<std::uint32_t> bits;
  for (const float v : values)
    bits.push_back(std::bit_cast<std::uint32_t>(v));
  return bits;
}

void expectSameBits(const Image& a, const Image& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  for (const Image::Channel& channel : b.channels) {
    const Image::Channel* original = a.find(channel.name);
    ASSERT_NE(original, nullptr) << channel.name;
    EXPECT_EQ(bitsOf(original->values), bitsOf(channel.values)) << channel.name;
  }
}

/// Every kind of float, and any bits at all.
Image everyKindOfFloat(int width, int height) {
  using Limits = std::numeric_limits<float>;
  const float odd[] = {0.0F,
                       -0.0F,
                       Limits::denorm_min(),
                       -Limits::denorm_min(),
                       1e-40F,
                       Limits::min(),
                       Limits::max(),
                       -Limits::max(),
                       Limits::infinity(),
                       -Limits::infinity(),
                       Limits::quiet_NaN(),
                       1.0F};
  Image image(width, height, {"R", "G", "B", "stderr.R", "stderr.G", "stderr.B"});
  auto random = randomOfTest();
  std::size_t i = 0;
  for (Image::Channel& channel : image.channels)
    for (float& v : channel.values)
      v = i++ % 3 == 0 ? odd[i / 3 % std::size(odd)]
                       : std::bit_cast<float>(static_cast<std::uint32_t>(random()));
  return image;
}

constexpr std::pair<int, int> kSizes[] = {{1, 1},   {7, 1},     {8, 3},     {1, 40},
                                          {61, 33}, {16384, 1}, {1, 16384}, {40000, 1}};

TEST(Formats, ExrAndPfmKeepEveryBit) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : kSizes) {
    const Image image = everyKindOfFloat(width, height);
    writeImage(folder / "x.exr", image, {.exposureStops = 3.0, .tonemap = Tonemap::Aces}, {});
    const Image exr = readImage(folder / "x.exr");
    EXPECT_EQ(exr.channels.size(), 6U);
    expectSameBits(image, exr);
    writeImage(folder / "x.pfm", image, {.exposureStops = 3.0, .tonemap = Tonemap::Aces}, {});
    const Image pfm = readImage(folder / "x.pfm");
    EXPECT_EQ(pfm.channels.size(), 3U);
    expectSameBits(image, pfm);
  }
}

/// RGBE holds every channel within half a step, 2^(e - 9), and the largest channel is 2^(e - 1) or more; from
/// 255.5 steps on it takes the next exponent, and its half step is 1/255.5 of it.
TEST(Formats, HdrKeepsWithinHalfAStep) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : kSizes) {
    Image image = noise(width, height);
    auto random = randomOfTest();
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
      const int exponent = static_cast<int>(random() % 220) - 100;
      for (Image::Channel& c : image.channels)
        c.values[i] = i % 4 == 0 ? 0.0F : std::ldexp(c.values[i], exponent);
    }
    writeImage(folder / "x.hdr", image, {.exposureStops = 3.0, .tonemap = Tonemap::Aces}, {});
    const Image back = readImage(folder / "x.hdr");
    ASSERT_EQ(back.width, width);
    ASSERT_EQ(back.height, height);
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
      const float largest =
          std::max({image.channels[0].values[i], image.channels[1].values[i], image.channels[2].values[i]});
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_LE(std::abs(back.channels[c].values[i] - image.channels[c].values[i]), largest / 255.5F);
    }
  }
}

/// stb cuts off; over many pixels that would darken the image by half a step, 0.25 % of a channel or more.
TEST(Formats, HdrHasNoBias) {
  const TemporaryFolder folder;
  const Image image = noise(100, 100);
  writeImage(folder / "x.hdr", image, {}, {});
  const Image back = readImage(folder / "x.hdr");
  double bias = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < image.pixelCount(); ++i)
      bias +=
          static_cast<double>(back.channels[c].values[i]) - static_cast<double>(image.channels[c].values[i]);
  // A rounding error is uniform in +-2^-9 at most: a deviation of 2^-9 / sqrt(3).
  EXPECT_LE(std::abs(bias / 30000.0), 4.0 / 512.0 / std::sqrt(3.0 * 30000.0));
}

TEST(Formats, HdrOfOddValues) {
  const TemporaryFolder folder;
  const float infinity = std::numeric_limits<float>::infinity(), most = std::ldexp(255.0F, 119);
  Image image(8, 1, {"R", "G", "B"});
  image.channels[0].values = {std::nanf(""), -0.7F,  infinity,        3.4e38F,
                              1e-33F,        1e-40F, 255.6F / 256.0F, -0.0F};
  image.channels[1].values = {0.5F, 0.5F, 1.0F, 0.0F, 0.0F, 0.0F, 100.5F / 256.0F, 0.0F};
  writeImage(folder / "x.hdr", image, {}, {});
  const Image back = readImage(folder / "x.hdr");
  EXPECT_EQ(back.channels[0].values, (std::vector<float>{0.0F, 0.0F, most, most, 0.0F, 0.0F, 1.0F, 0.0F}));
  EXPECT_EQ(back.channels[1].values,
            (std::vector<float>{0.5F, 0.5F, 0.0F, 0.0F, 0.0F, 0.0F, 100.0F / 256.0F, 0.0F}));
}

TEST(Formats, HdrOfOthers) {
  const TemporaryFolder folder;
  using namespace std::string_literals;
  // Flat pixels in a row that could be coded, a second exposure, no FORMAT.
  std::string text = "#?RGBE\n# by hand\nEXPOSURE= 2\nEXPOSURE=4.0\n\n-Y 2 +X 8\n";
  for (int i = 0; i < 16; ++i)
    text += "\x80\x40\x02\x81"s;
  writeBytes(folder / "x.hdr", viewOf(text));
  const Image image = readImage(folder / "x.hdr");
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(image.channels[0].values[i], 1.0F / 8.0F);
    EXPECT_EQ(image.channels[1].values[i], 0.5F / 8.0F);
    EXPECT_EQ(image.channels[2].values[i], 2.0F / 128.0F / 8.0F);
  }
  writeBytes(folder / "x.hdr", viewOf("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n\1\2\3\4"));
  EXPECT_NE(messageOf<SceneError>([&] { readImage(folder / "x.hdr"); }).find("32-bit_rle_xyze"),
            std::string::npos);
  writeBytes(folder / "x.hdr", viewOf("#?RADIANCE\n\n+Y 1 +X 1\n\1\2\3\4"));
  EXPECT_NE(messageOf<SceneError>([&] { readImage(folder / "x.hdr"); }).find("-Y height +X width"),
            std::string::npos);
}

TEST(Formats, PfmIsLittleEndianWithItsBottomRowFirst) {
  const TemporaryFolder folder;
  Image image(1, 2, {"R", "G", "B"});
  image.channels[0].values = {1.0F, 2.0F};
  writeImage(folder / "x.pfm", image, {}, {});
  const film::Bytes bytes = film::readWholeFile(folder / "x.pfm");
  const std::string_view header = "PF\n1 2\n-1.0\n";
  ASSERT_EQ(bytes.size(), header.size() + 24);
  EXPECT_EQ(std::memcmp(bytes.data(), header.data(), header.size()), 0);
  EXPECT_EQ(std::memcmp(bytes.data() + header.size(), "\0\0\0\x40", 4), 0); // 2.0F, of the second row
}

TEST(Formats, PfmOfOthers) {
  const TemporaryFolder folder;
  using namespace std::string_literals;
  writeBytes(folder / "x.pfm", viewOf("Pf 2\t1\r\n2\n\x3f\x80\0\0\xc0\0\0\0"s)); // grey, big endian, times 2
  const Image image = readImage(folder / "x.pfm");
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_EQ(image.channels[c].values, (std::vector<float>{2.0F, -4.0F}));
}

struct Chunk {
  std::string type, data;
};
std::vector<Chunk> chunksOf(const film::Bytes& png) {
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t size = png[at] * 16777216UL + png[at + 1] * 65536UL + png[at + 2] * 256UL + png[at + 3];
    const std::string all(png.begin() + static_cast<std::ptrdiff_t>(at),
                          png.begin() + static_cast<std::ptrdiff_t>(at + 8 + size));
    chunks.push_back({all.substr(4, 4), all.substr(8)});
    at += 12 + size;
  }
  return chunks;
}

TEST(Formats, PngCarriesMetadataAsText) {
  const TemporaryFolder folder;
  using namespace std::string_literals;
  writeImage(folder / "x.png", noise(9, 5), {},
             {{"scene", "box.obj"},
              {"seconds", 0.1},
              {"seed", std::int64_t{-7}},
              {"who", "J\xC3\xBCrg"},
              {"zero", "a\0b"s}});
  const std::vector<Chunk> chunks = chunksOf(film::readWholeFile(folder / "x.png"));
  const std::vector<Chunk> expected{{"tEXt", "vkpt.scene\0box.obj"s},
                                    {"tEXt", "vkpt.seconds\0"
                                             "0.1"s},
                                    {"tEXt", "vkpt.seed\0-7"s},
                                    {"iTXt", "vkpt.who\0\0\0\0\0J\xC3\xBCrg"s},
                                    {"tEXt", "vkpt.zero\0ab"s}};
  ASSERT_EQ(chunks.size(), 3 + expected.size());
  EXPECT_EQ(chunks.front().type, "IHDR");
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(chunks[i + 1].type, expected[i].type);
    EXPECT_EQ(chunks[i + 1].data, expected[i].data);
  }
  EXPECT_EQ(readImage(folder / "x.png").width, 9); // looks at the CRCs too
}

/// An independent figure: the CRC-32 of "IEND" is AE426082 in every PNG; of our chunk, by zlib.crc32 of
/// Python.
TEST(Formats, PngTextHasTheRightCrc) {
  const TemporaryFolder folder;
  writeImage(folder / "x.png", noise(1, 1), {}, {{"seed", std::int64_t{42}}});
  const film::Bytes png = film::readWholeFile(folder / "x.png");
  const std::size_t text = 33 + 8;
  ASSERT_EQ(std::memcmp(png.data() + text,
                        "vkpt.seed\0"
                        "42",
                        12),
            0);
  EXPECT_EQ(std::memcmp(png.data() + text + 12, "\x6c\x25\x8e\x88", 4), 0);
}

TEST(Formats, PngSizes) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : kSizes) {
    const Image image = noise(width, height);
    writeImage(folder / "x.png", image, {.tonemap = Tonemap::Srgb}, {});
    const Image back = readImage(folder / "x.png");
    ASSERT_EQ(back.width, width);
    ASSERT_EQ(back.height, height);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < image.pixelCount();
           ++i) // half a step of 1/255 where the curve is steepest, 2.28
        ASSERT_NEAR(back.channels[c].values[i], image.channels[c].values[i], 0.5 / 255.0 * 2.28);
  }
}

/// The bounds on what a file of some bytes can hold let through what packs best.
TEST(Formats, AConstantIsRead) {
  const TemporaryFolder folder;
  const Image black(1016, 1000, {"R", "G", "B"});
  for (const std::string_view extension : kExtensions) {
    const fs::path path = folder / std::string("x").append(extension);
    writeImage(path, black, {}, {});
    expectSameBits(black, readImage(path));
  }
}

TEST(Formats, ExtensionsInCapitals) {
  const TemporaryFolder folder;
  const Image image = noise(5, 4);
  for (const char* name : {"x.PNG", "x.Exr", "x.HDR", "x.PFM"}) {
    writeImage(folder / name, image, {}, {});
    EXPECT_EQ(readImage(folder / name).height, 4);
  }
}

/// A decimal comma and grouped thousands.
class Continental : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Formats, TheLocaleDoesNotMatter) {
  const TemporaryFolder folder;
  const Image image = noise(1234, 1);
  const Metadata metadata{{"seconds", 1234.5}, {"seed", std::int64_t{1234567}}};
  std::vector<film::Bytes> expected;
  for (const std::string_view extension : kExtensions) {
    writeImage(folder / std::string("a").append(extension), image, {}, metadata);
    expected.push_back(film::readWholeFile(folder / std::string("a").append(extension)));
  }
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Continental));
  const std::string numbers = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) // where the system has one
    if (std::setlocale(LC_NUMERIC, name) != nullptr)
      break;
  for (std::size_t i = 0; i < 4; ++i) {
    const fs::path path = folder / std::string("b").append(kExtensions[i]);
    writeImage(path, image, {}, metadata);
    EXPECT_EQ(film::readWholeFile(path), expected[i]) << kExtensions[i];
    EXPECT_EQ(readImage(path).width, 1234);
  }
  std::setlocale(LC_NUMERIC, numbers.c_str());
  std::locale::global(before);
}

} // namespace
} // namespace vkpt::test
