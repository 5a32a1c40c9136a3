#pragma once
// The check sum of PNG.

#include "decode/picture.h"

#include <cstdint>

namespace vkpt::decode {

/// CRC-32 of a chunk's type and data (ISO 3309, reflected polynomial EDB88320).
std::uint32_t crc32(ByteView bytes);

} // namespace vkpt::decode
