// Image files. What an input starts with says which of the readers gets it, as a file's extension does.

#include "decode/crc32.h"
#include "film/codecs.h"
#include "fuzz/input.h"
#include "fuzz/memory_bound.h"

#include <algorithm>
#include <exception>
#include <new>

namespace {

/// What the compressed formats can make of a byte. PNG: deflate makes 1032 bytes of one, of 8 pixels each at
/// a bit, and a pixel takes 12 bytes as floats and 6 as 16-bit samples; the film has its planes beside them.
constexpr std::size_t kBytesPerByte = std::size_t{1032} * 8 * 32;
constexpr std::size_t kBytesForNothing = std::size_t{1} << 28U; // 2^24 samples of an EXR file
constexpr std::size_t kMostBytes = std::size_t{1} << 30U;

/// A chunk's CRC would let no mutation through: each is made right. Chunks that do not fit end it.
void repairPng(vkpt::film::Bytes& file) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kOverhead = 12; // length, type, CRC
  for (std::size_t at = kSignature; at + kOverhead <= file.size();) {
    const std::size_t length =
        file[at] * 0x1000000ULL + file[at + 1] * 0x10000ULL + file[at + 2] * 0x100ULL + file[at + 3];
    if (length > file.size() - at - kOverhead) {
      return;
    }
    const std::uint32_t crc = vkpt::decode::crc32({file.data() + at + 4, 4 + length});
    for (std::size_t i = 0; i < 4; ++i) {
      file[at + 8 + length + i] = static_cast<unsigned char>(crc >> (24U - 8U * i));
    }
    at += kOverhead + length;
  }
}

void decode(vkpt::film::ByteView file) {
  const std::string_view text = vkpt::test::textOf(file.data(), file.size());
  if (text.starts_with("\x76\x2f\x31\x01")) {
    static_cast<void>(vkpt::film::decodeExr(file));
  } else if (text.starts_with("PF") || text.starts_with("Pf")) {
    static_cast<void>(vkpt::film::decodePfm(file));
  } else { // by content: PNG, HDR, JPEG, BMP, else TGA
    static_cast<void>(vkpt::film::planesOf(vkpt::decode::decodePicture(file)));
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  vkpt::film::Bytes file(data, data + size);
  if (vkpt::test::textOf(data, size).starts_with("\x89PNG\r\n\x1a\n")) {
    repairPng(file);
  }
  const vkpt::test::MemoryBound bound(std::min(kMostBytes, kBytesForNothing + kBytesPerByte * size));
  try {
    decode(file);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) { // what readImage() turns into a SceneError
  }
  return 0;
}
