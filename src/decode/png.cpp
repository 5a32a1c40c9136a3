// PNG (ISO/IEC 15948): the pixels through stb; the check of the CRCs is ours.

#include "decode/crc32.h"
#include "decode/samples.h"

#include <algorithm>
#include <array>

namespace vkpt::decode {

namespace {

constexpr std::array<unsigned char, 8> kSignature{137, 'P', 'N', 'G', 13, 10, 26, 10};
constexpr std::size_t kChunkOverhead = 12; // length, type, CRC

std::uint32_t bigEndian(ByteView b) {
  return (std::uint32_t{b[0]} << 24U) | (std::uint32_t{b[1]} << 16U) | (std::uint32_t{b[2]} << 8U) | b[3];
}

/// The bytes of an image before they were deflated; `header`: the data of its IHDR. 0 where that is none.
std::uint64_t rawBytes(ByteView header) {
  constexpr std::size_t kHeaderBytes = 13;
  constexpr std::array<std::uint64_t, 7> kSamplesOfColourType{1, 0, 3, 1, 2, 0, 4};
  if (header.size() < kHeaderBytes || header[9] >= kSamplesOfColourType.size())
    return 0;
  const std::uint64_t bitsOfRow = bigEndian(header) * kSamplesOfColourType[header[9]] * header[8];
  return bigEndian(header.subspan(4)) * (1 + bitsOfRow / 8); // a row starts with the kind of its filter
}

/// stb does not look at the CRCs, takes the end of the data for zeros, and allocates what the header claims.
void checkChunks(ByteView file) {
  if (!startsAsPng(file))
    throw FormatError("is no PNG file");
  constexpr std::uint64_t kMostBytesOfDeflated = 1032; // RFC 1951: 258 for two bits
  std::uint64_t raw = 0, deflated = 0;
  ByteView rest = file.subspan(kSignature.size());
  for (;;) {
    if (rest.size() < kChunkOverhead || bigEndian(rest) > rest.size() - kChunkOverhead)
      throw FormatError("broken PNG: the file ends too soon");
    const std::size_t length = bigEndian(rest);
    const ByteView type = rest.subspan(4, 4);
    if (crc32(rest.subspan(4, 4 + length)) != bigEndian(rest.subspan(8 + length)))
      throw FormatError("broken PNG: a chunk's CRC is wrong");
    const auto is = [&](const char* name) { return std::equal(type.begin(), type.end(), name); };
    if (is("IHDR"))
      raw = rawBytes(rest.subspan(8, length));
    if (is("IDAT"))
      deflated += length;
    if (is("IEND"))
      break;
    rest = rest.subspan(kChunkOverhead + length);
  }
  if (raw / kMostBytesOfDeflated > deflated)
    throw FormatError("broken PNG: it ends too soon for its size");
}

} // namespace

bool startsAsPng(ByteView file) {
  return file.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), file.begin());
}

Picture decodePng(ByteView file) {
  checkChunks(file);
  return linearPicture(stbDecode(file));
}

} // namespace vkpt::decode
