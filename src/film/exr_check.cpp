#include "film/exr_check.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace vkpt::film {

namespace {

static_assert(std::endian::native == std::endian::little, "the fields of EXR's header are little endian");

std::uint32_t word(ByteView bytes, std::size_t at) {
  std::uint32_t v = 0;
  std::memcpy(&v, bytes.data() + at, sizeof v);
  return v;
}

/// What OpenEXR reads of a type, whatever size the file gives: a different one makes it read the rest askew.
struct FixedSize {
  std::string_view type;
  std::size_t bytes;
};
constexpr std::array kFixedSizes{
    FixedSize{"int", 4},       FixedSize{"float", 4},
    FixedSize{"double", 8},    FixedSize{"box2i", 16},
    FixedSize{"box2f", 16},    FixedSize{"v2i", 8},
    FixedSize{"v2f", 8},       FixedSize{"v2d", 16},
    FixedSize{"v3i", 12},      FixedSize{"v3f", 12},
    FixedSize{"v3d", 24},      FixedSize{"m33f", 36},
    FixedSize{"m33d", 72},     FixedSize{"m44f", 64},
    FixedSize{"m44d", 128},    FixedSize{"compression", 1},
    FixedSize{"lineOrder", 1}, FixedSize{"envmap", 1},
    FixedSize{"rational", 8},  FixedSize{"timecode", 8},
    FixedSize{"keycode", 28},  FixedSize{"chromaticities", 32},
    FixedSize{"tiledesc", 9},  FixedSize{"deepImageState", 1},
};

/// Takes a header apart as OpenEXR does.
class AttributeChecker {
public:
  explicit AttributeChecker(ByteView file) : m_rest(file.subspan(kFirstExrAttribute)) {}

  void run() {
    while (!text(m_rest).empty()) { // the name; an empty one ends the header
      const std::string_view type = text(m_rest);
      const std::size_t size = m_rest.size() < 4 ? m_rest.size() : word(take(4), 0);
      checkValue(type, take(size));
    }
  }

private:
  [[noreturn]] static void fail() { throw FormatError("broken EXR: its header does not end"); }

  ByteView take(std::size_t bytes) {
    if (bytes > m_rest.size())
      fail();
    const ByteView taken = m_rest.first(bytes);
    m_rest = m_rest.subspan(bytes);
    return taken;
  }

  /// Up to a zero byte, which is taken too.
  static std::string_view text(ByteView& from) {
    constexpr std::ptrdiff_t kLongest = 254; // OpenEXR goes on behind 255 characters, zero or not
    const auto end = std::find(from.begin(), from.end(), 0);
    const std::ptrdiff_t length = end - from.begin();
    if (end == from.end() || length > kLongest)
      fail();
    const std::string_view found(reinterpret_cast<const char*>(from.data()),
                                 static_cast<std::size_t>(length));
    from = from.subspan(static_cast<std::size_t>(length) + 1);
    return found;
  }

  static void checkValue(std::string_view type, ByteView value) {
    const auto fixed = std::ranges::find(kFixedSizes, type, &FixedSize::type);
    if (fixed != kFixedSizes.end() && value.size() != fixed->bytes)
      fail();
    if (type == "chlist")
      checkChannels(value);
    if (type == "preview" && (value.size() < 8 || 8 + 4ULL * word(value, 0) * word(value, 4) != value.size()))
      fail();
  }

  /// Names and 16 bytes each; an empty name ends the list.
  static void checkChannels(ByteView value) {
    constexpr std::size_t kBytesOfChannel = 16;
    while (!text(value).empty()) {
      if (value.size() < kBytesOfChannel)
        fail();
      value = value.subspan(kBytesOfChannel);
    }
    if (!value.empty())
      fail();
  }

  ByteView m_rest;
};

/// How a compression packs samples of two bytes or more.
struct Packing {
  double samplesPerByte; ///< at most
  std::int64_t rows;     ///< that are unpacked together, so OpenEXR makes room for so many
};

Packing packingOf(Imf::Compression compression) {
  constexpr double kDeflate = 1032.0; // bytes of one
  switch (compression) {
  case Imf::NO_COMPRESSION:
    return {0.5, 1};
  case Imf::RLE_COMPRESSION: // 128 bytes of two
    return {32.0, 1};
  case Imf::ZIPS_COMPRESSION:
    return {kDeflate / 2.0, 1};
  case Imf::ZIP_COMPRESSION:
  case Imf::PXR24_COMPRESSION:
    return {kDeflate / 2.0, 16};
  case Imf::PIZ_COMPRESSION: // 255 samples of a code and a byte
    return {kDeflate / 2.0, 32};
  case Imf::B44_COMPRESSION:
  case Imf::B44A_COMPRESSION: // 16 samples of three bytes
    return {16.0 / 3.0, 32};
  case Imf::DWAA_COMPRESSION: // packs blocks of 64 before it deflates
    return {64.0 * kDeflate, 32};
  default:
    return {64.0 * kDeflate, 256};
  }
}

std::int64_t roundUp(std::int64_t n, std::int64_t unit) {
  return unit > 0 ? (n + unit - 1) / unit * unit : n;
}

/// How many samples OpenEXR and we make room for: whole blocks of rows, or whole tiles.
double samplesOf(const Imf::Header& header, std::int64_t width, std::int64_t height) {
  std::int64_t rows = packingOf(header.compression()).rows;
  std::int64_t columns = 1;
  if (header.hasTileDescription()) {
    columns = header.tileDescription().xSize;
    rows = header.tileDescription().ySize;
  }
  double channels = 0.0;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
    channels += 1.0;
  return channels * static_cast<double>(roundUp(width, columns)) * static_cast<double>(roundUp(height, rows));
}

} // namespace

int checkExrAttributes(ByteView file) {
  if (file.size() < kFirstExrAttribute || word(file, 0) != static_cast<std::uint32_t>(Imf::MAGIC))
    throw FormatError("is no EXR file");
  const int version = static_cast<int>(word(file, 4));
  if ((version & (Imf::NON_IMAGE_FLAG | Imf::MULTI_PART_FILE_FLAG)) != 0)
    throw FormatError("EXR with deep pixels or several parts; only a single flat image can be read");
  AttributeChecker(file).run();
  return version;
}

bool exrFileJustifies(std::size_t bytes, const Imf::Header& header, std::int64_t width, std::int64_t height) {
  constexpr double kSamplesOfAnyFile = 1 << 24; // a small image may stand in a large tile
  const double most = packingOf(header.compression()).samplesPerByte * static_cast<double>(bytes);
  return samplesOf(header, width, height) <= kSamplesOfAnyFile + most;
}

} // namespace vkpt::film
