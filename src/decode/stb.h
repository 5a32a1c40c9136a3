#pragma once
// The part of stb_image that we use; the only way to it.

#include "decode/picture.h"

#include <cstdint>
#include <memory>

namespace vkpt::decode {

/// 16-bit samples as R, G, B, row by row; those of 8 bits are multiplied by 257.
struct Samples {
  int width = 0;
  int height = 0;
  std::unique_ptr<std::uint16_t[], void (*)(void*)> rgb; ///< what C's malloc gave
};

/// A PNG, JPEG, BMP or TGA; grey becomes R = G = B, alpha is dropped. Throws FormatError with stb's reason.
Samples stbDecode(ByteView file);

} // namespace vkpt::decode
