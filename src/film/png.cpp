// PNG (ISO/IEC 15948): the pixels through stb; the text chunks and the check of the CRCs are ours.

#include "film/codecs.h"
#include "film/display.h"
#include "film/stb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <string_view>

namespace vkpt::film {

namespace {

constexpr std::size_t kSignatureSize = 8;
constexpr std::array<unsigned char, kSignatureSize> kSignature{137, 'P', 'N', 'G', 13, 10, 26, 10};
constexpr std::size_t kChunkOverhead = 12; // length, type, CRC
constexpr std::size_t kHeaderEnd = kSignatureSize + kChunkOverhead + 13;

/// CRC-32 of a chunk's type and data (ISO 3309, reflected polynomial EDB88320).
std::uint32_t crc32(ByteView bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> t{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      t[i] = i;
      for (int bit = 0; bit < 8; ++bit)
        t[i] = (t[i] & 1U) != 0U ? (t[i] >> 1U) ^ 0xEDB88320U : t[i] >> 1U;
    }
    return t;
  }();
  std::uint32_t c = 0xFFFFFFFFU;
  for (const unsigned char b : bytes)
    c = table[(c ^ b) & 0xFFU] ^ (c >> 8U);
  return ~c;
}

void putBigEndian(Bytes& out, std::uint32_t v) {
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    out.push_back(static_cast<unsigned char>((v >> shift) & 0xFFU));
}

std::uint32_t bigEndian(ByteView b) {
  return (std::uint32_t{b[0]} << 24U) | (std::uint32_t{b[1]} << 16U) | (std::uint32_t{b[2]} << 8U) | b[3];
}

void putChunk(Bytes& out, std::string_view type, std::string_view data) {
  putBigEndian(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = out.size();
  out.insert(out.end(), type.begin(), type.end());
  out.insert(out.end(), data.begin(), data.end());
  putBigEndian(out, crc32(ByteView(out).subspan(start)));
}

std::string textOf(const Metadata::mapped_type& value) {
  std::string text = std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
  std::erase(text, '\0'); // the one character that PNG text cannot hold
  return text;
}

/// tEXt is Latin-1; text beyond ASCII goes into iTXt, which is UTF-8.
void putText(Bytes& out, const std::string& keyword, const std::string& text) {
  assert(!keyword.empty() && keyword.size() <= 79);
  const bool ascii =
      std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
  using namespace std::string_literals;
  if (ascii)
    putChunk(out, "tEXt", keyword + "\0"s + text);
  else // not compressed, no language, no translated keyword
    putChunk(out, "iTXt", keyword + "\0\0\0\0\0"s + text);
}

/// stb does not look at the CRCs, and takes the end of the data for zeros.
void checkChunks(ByteView file) {
  if (file.size() < kSignatureSize || !std::equal(kSignature.begin(), kSignature.end(), file.begin()))
    throw FormatError("is no PNG file");
  ByteView rest = file.subspan(kSignatureSize);
  for (;;) {
    if (rest.size() < kChunkOverhead || bigEndian(rest) > rest.size() - kChunkOverhead)
      throw FormatError("broken PNG: the file ends too soon");
    const std::size_t length = bigEndian(rest);
    const ByteView type = rest.subspan(4, 4);
    if (crc32(rest.subspan(4, 4 + length)) != bigEndian(rest.subspan(8 + length)))
      throw FormatError("broken PNG: a chunk's CRC is wrong");
    if (std::equal(type.begin(), type.end(), "IEND"))
      return;
    rest = rest.subspan(kChunkOverhead + length);
  }
}

} // namespace

void checkPngSize(int width, int height) {
  constexpr std::uint64_t kMostBytes = 900'000'000; // 9/8 of it, stb's worst case, stays below 2^30
  const auto w = static_cast<std::uint64_t>(width), h = static_cast<std::uint64_t>(height);
  if (width > (1 << 24) || height > (1 << 24) || (3 * w + 1) * h > kMostBytes)
    throw UsageError(fmt::format("{}x{} pixels are too many for .png; use .exr or .pfm", width, height));
}

void writePng(AtomicFile& out, const Image& image, const DisplaySettings& display, const Metadata& metadata) {
  checkPngSize(image.width, image.height);
  const auto planes = colourPlanes(image);
  const DisplayTransform transform(display);
  Bytes rgb(3 * image.pixelCount());
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      rgb[3 * i + c] = transform.byte(planes[c][i]);
  const Bytes png = stbEncodePng(image.width, image.height, rgb.data());
  Bytes texts;
  for (const auto& [key, value] : metadata)
    putText(texts, metadataName(key), textOf(value));
  out.write(ByteView(png).first(kHeaderEnd));
  out.write(texts);
  out.write(ByteView(png).subspan(kHeaderEnd));
}

Image decodePng(ByteView file) {
  checkChunks(file);
  const DecodedPng png = stbDecodePng(file);
  Image image(png.width, png.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      image.channels[c].values[i] = static_cast<float>(srgbDecode(png.rgb[3 * i + c] / 65535.0));
  return image;
}

} // namespace vkpt::film
