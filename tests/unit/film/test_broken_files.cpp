// No file makes the readers do anything but read it or throw a SceneError that names it.

#include "unit/film/film_fixtures.h"

#include "film/codecs.h"

#include <fmt/format.h>

#include <array>
#include <sys/resource.h>

namespace vkpt::test {
namespace {

enum class Outcome { Read, Refused };

/// Anything but a SceneError that begins with the file's name comes through and fails the test.
Outcome outcomeOf(const fs::path& path, film::ByteView bytes) {
  writeBytes(path, bytes);
  try {
    const Image image = readImage(path);
    EXPECT_GT(image.pixelCount(), 0U);
    for (const Image::Channel& channel : image.channels)
      EXPECT_EQ(channel.values.size(), image.pixelCount());
    return Outcome::Read;
  } catch (const SceneError& e) {
    EXPECT_TRUE(std::string_view(e.what()).starts_with(path.string() + ": ")) << e.what();
    EXPECT_EQ(std::string_view(e.what()).find('\n'), std::string_view::npos) << e.what();
    return Outcome::Refused;
  }
}

class BrokenFiles : public ::testing::TestWithParam<std::string_view> {
protected:
  [[nodiscard]] fs::path path() const { return m_folder / std::string("x").append(GetParam()); }
  /// A right file with rows long enough for runs, and metadata.
  [[nodiscard]] film::Bytes right() const {
    Image image = noise(24, 17);
    std::fill_n(image.channels[1].values.begin(), 200, 0.5F);
    writeImage(path(), image, {}, {{"scene", "box"}, {"seed", std::int64_t{5}}});
    return film::readWholeFile(path());
  }

private:
  TemporaryFolder m_folder;
};

TEST_P(BrokenFiles, EveryTruncationIsRefused) {
  const film::Bytes whole = right();
  ASSERT_EQ(outcomeOf(path(), whole), Outcome::Read);
  for (std::size_t length = 0; length < whole.size(); ++length)
    ASSERT_EQ(outcomeOf(path(), film::ByteView(whole).first(length)), Outcome::Refused)
        << length << " of " << whole.size();
}

TEST_P(BrokenFiles, ChangedBytesDoNoHarm) {
  const film::Bytes whole = right();
  auto random = randomOfTest();
  int refused = 0, tried = 0;
  constexpr int kRounds = 1500;
  for (int round = 0; round < kRounds; ++round) {
    film::Bytes bytes = whole;
    const std::size_t reach =
        round % 2 == 0 ? std::min<std::size_t>(bytes.size(), 400) : bytes.size(); // the header
    for (std::uint64_t changes = 1 + random() % 4; changes > 0; --changes) {
      unsigned char& b = bytes[random() % reach];
      b = static_cast<unsigned char>(b ^ (1 + random() % 255));
    }
    if (bytes == whole) // one change undid another
      continue;
    ++tried;
    refused += outcomeOf(path(), bytes) == Outcome::Refused ? 1 : 0;
  }
  if (GetParam() == ".png")
    EXPECT_EQ(refused, tried); // its CRCs see every change
  else
    EXPECT_GT(refused, 0);
}

TEST_P(BrokenFiles, GarbageIsRefused) {
  const film::Bytes whole = right();
  auto random = randomOfTest();
  for (int round = 0; round < 400; ++round) {
    film::Bytes bytes(random() % 2000);
    for (unsigned char& b : bytes)
      b = static_cast<unsigned char>(random());
    ASSERT_EQ(outcomeOf(path(), bytes), Outcome::Refused);
    const std::size_t kept = std::min({bytes.size(), whole.size(), static_cast<std::size_t>(random() % 64)});
    std::copy_n(whole.begin(), kept, bytes.begin()); // behind a right beginning
    outcomeOf(path(), bytes);
  }
}

TEST_P(BrokenFiles, WhatIsNoFileIsRefused) {
  const auto refusal = [&] { return messageOf<SceneError>([&] { readImage(path()); }); };
  EXPECT_EQ(refusal(), path().string() + ": cannot be read: No such file or directory");
  fs::create_directory(path());
  EXPECT_EQ(refusal(), path().string() + ": cannot be read: Is a directory");
}

INSTANTIATE_TEST_SUITE_P(Formats, BrokenFiles, ::testing::ValuesIn(kExtensions),
                         [](const auto& format) { return std::string(format.param.substr(1)); });

TEST(ReadImage, AnUnknownFormatIsNamed) {
  EXPECT_EQ(messageOf<SceneError>([] { readImage("x.tiff"); }),
            "x.tiff: unknown image format; use .png, .exr, .hdr or .pfm");
}

/// The largest resident size that this process has had, in MiB.
double peakMebibytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// A size that the file cannot hold is refused before memory is taken for it: 100 MiB is far below any of
/// them.
TEST(ReadImage, AHugeSizeCostsNoMemory) {
  const TemporaryFolder folder;
  const double before = peakMebibytes();
  for (const char* size :
       {"2147483647 2147483647", "30000 30000", "1 2147483647", "99999999999 1", "0 5", "-3 4"}) {
    const std::string pfm = fmt::format("PF\n{}\n-1.0\n", size);
    EXPECT_EQ(outcomeOf(folder / "x.pfm", viewOf(pfm)), Outcome::Refused);
    const std::string text(size);
    const std::size_t space = text.find(' ');
    const std::string hdr =
        fmt::format("#?RADIANCE\n\n-Y {} +X {}\n\2\2\1\1", text.substr(0, space), text.substr(space + 1));
    EXPECT_EQ(outcomeOf(folder / "x.hdr", viewOf(hdr)), Outcome::Refused);
  }
  writeImage(folder / "x.exr", noise(8, 8), {}, {{"scene", "box"}});
  const film::Bytes right = film::readWholeFile(folder / "x.exr");
  const auto exrWith = [&](std::string_view attribute, std::size_t at,
                           std::initializer_list<unsigned char> bytes) {
    film::Bytes exr = right;
    const auto found = std::search(exr.begin(), exr.end(), attribute.begin(), attribute.end());
    EXPECT_NE(found, exr.end());
    std::ranges::copy(bytes, found + static_cast<std::ptrdiff_t>(attribute.size() + at));
    return exr;
  };
  constexpr std::string_view kWindow("dataWindow\0box2i\0\x10\0\0\0", 21), kText("vkpt.scene\0string\0", 18);
  for (const unsigned char side :
       std::array<unsigned char, 4>{0x1F, 0x3F, 0x7F, 0xFF}) { // 8191 pixels a side
    const film::Bytes exr = exrWith(kWindow, 8, {0xFF, side, 0, 0, 0xFF, side, 0, 0});
    EXPECT_EQ(outcomeOf(folder / "x.exr", exr), Outcome::Refused);
  }
  EXPECT_EQ(outcomeOf(folder / "x.exr", exrWith(kWindow, 8, {0, 0, 0, 0x7F, 0, 0, 0, 0x7F})),
            Outcome::Refused);
  // Eight rows, as there are, but long: the file's table of offsets is right.
  EXPECT_EQ(outcomeOf(folder / "x.exr", exrWith(kWindow, 8, {0, 0, 0x7F, 0})), Outcome::Refused);
  for (const unsigned char top : std::array<unsigned char, 3>{0x20, 0x7F, 0xFF}) // a text of half a GiB
    EXPECT_EQ(outcomeOf(folder / "x.exr", exrWith(kText, 0, {0, 0, 0, top})), Outcome::Refused);
  // Sizes that are not their types': OpenEXR would read the rest of the header askew, and a size from the
  // middle.
  EXPECT_EQ(outcomeOf(folder / "x.exr", exrWith(std::string_view("dataWindow\0box2i\0", 17), 0, {0x11})),
            Outcome::Refused);
  EXPECT_EQ(outcomeOf(folder / "x.exr", exrWith(std::string_view("channels\0chlist\0", 16), 4, {0})),
            Outcome::Refused);
  EXPECT_LT(peakMebibytes() - before, 100.0);
}

} // namespace
} // namespace vkpt::test
