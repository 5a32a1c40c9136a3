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

/// stb does not look at the CRCs, and takes the end of the data for zeros.
void checkChunks(ByteView file) {
  if (!startsAsPng(file))
    throw FormatError("is no PNG file");
  ByteView rest = file.subspan(kSignature.size());
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

bool startsAsPng(ByteView file) {
  return file.size() >= kSignature.size() && std::equal(kSignature.begin(), kSignature.end(), file.begin());
}

Picture decodePng(ByteView file) {
  checkChunks(file);
  return linearPicture(stbDecode(file));
}

} // namespace vkpt::decode
