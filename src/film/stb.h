#pragma once
// The part of stb_image_write that we use; the only way to it.

#include "film/file_io.h"

#include <cstdint>
#include <memory>

namespace vkpt::film {

/// What C's malloc gave.
template<class T>
using CBuffer = std::unique_ptr<T[], void (*)(void*)>;

/// `rgb`: 8-bit samples, row by row. Throws std::bad_alloc.
Bytes stbEncodePng(int width, int height, const std::uint8_t* rgb);
/// `rgb`: float samples >= 0, row by row. stb cuts off to RGBE, it does not round.
void stbWriteHdr(AtomicFile& out, int width, int height, const float* rgb);

} // namespace vkpt::film
