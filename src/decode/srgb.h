#pragma once
// The curve of sRGB (IEC 61966-2-1).

#include <cmath>

namespace vkpt::decode {

/// Of a value in [0, 1].
inline double srgbDecode(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

} // namespace vkpt::decode
