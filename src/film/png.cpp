// PNG (ISO/IEC 15948): the pixels through stb; the text chunks are ours.

#include "decode/crc32.h"
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
constexpr std::size_t kChunkOverhead = 12; // length, type, CRC
constexpr std::size_t kHeaderEnd = kSignatureSize + kChunkOverhead + 13;

void putBigEndian(Bytes& out, std::uint32_t v) {
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    out.push_back(static_cast<unsigned char>((v >> shift) & 0xFFU));
}

void putChunk(Bytes& out, std::string_view type, std::string_view data) {
  putBigEndian(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = out.size();
  out.insert(out.end(), type.begin(), type.end());
  out.insert(out.end(), data.begin(), data.end());
  putBigEndian(out, decode::crc32(ByteView(out).subspan(start)));
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

Image decodePng(ByteView file) { return planesOf(decode::decodePng(file)); }

} // namespace vkpt::film
