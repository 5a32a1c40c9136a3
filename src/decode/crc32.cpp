#include "decode/crc32.h"

#include <array>

namespace vkpt::decode {

std::uint32_t crc32(ByteView bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> t{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      t[i] = i;
      for (int bit = 0; bit < 8; ++bit)
        t[i] = (t[i] & 1U) != 0U ? (t[i] >> 1U) ^ 0xEDB88320U : t[i] >> 1U;
    }
    return t;
  }();
  std::uint32_t c = 0xFFFFFFFFU;
  for (const unsigned char b : bytes)
    c = table[(c ^ b) & 0xFFU] ^ (c >> 8U);
  return ~c;
}

} // namespace vkpt::decode
