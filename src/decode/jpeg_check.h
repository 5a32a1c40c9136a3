#pragma once
// What stb_image (2.27) does not check in a JPEG.

#include "decode/picture.h"

namespace vkpt::decode {

/// Throws FormatError at a Huffman table of more than 256 codes, for which stb writes past its arrays. Does
/// nothing with what is no JPEG.
void checkJpeg(ByteView file);

} // namespace vkpt::decode
