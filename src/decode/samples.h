#pragma once
// What the decoders share.

#include "decode/stb.h"

namespace vkpt::decode {

bool startsAsPng(ByteView file);
/// The samples decoded from sRGB.
Picture linearPicture(const Samples& samples);

} // namespace vkpt::decode
