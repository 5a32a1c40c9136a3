#pragma once
// The part of stb_image and stb_image_write that we use; the only way to them.

#include "film/file_io.h"

#include <cstdint>
#include <memory>

namespace vkpt::film {

/// What C's malloc gave.
template<class T>
using CBuffer = std::unique_ptr<T[], void (*)(void*)>;

/// 16-bit samples of a PNG as R, G, B, row by row; those of 8 bits are multiplied by 257.
struct DecodedPng {
  int width = 0;
  int height = 0;
  CBuffer<std::uint16_t> rgb;
};

/// Throws FormatError with stb's reason.
DecodedPng stbDecodePng(ByteView file);
/// `rgb`: 8-bit samples, row by row. Throws std::bad_alloc.
Bytes stbEncodePng(int width, int height, const std::uint8_t* rgb);
/// `rgb`: float samples >= 0, row by row. stb cuts off to RGBE, it does not round.
void stbWriteHdr(AtomicFile& out, int width, int height, const float* rgb);

} // namespace vkpt::film
