#pragma once
// Image files into pixels. What is written is the film's.

#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace vkpt::decode {

using Bytes = std::vector<unsigned char>;
using ByteView = std::span<const unsigned char>;

/// A file that breaks its format.
class FormatError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Linear R, G, B, pixel by pixel, row 0 at the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;

  [[nodiscard]] std::size_t pixelCount() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Of 8 or 16 bits, decoded from sRGB whatever its gAMA; alpha is dropped. Throws FormatError.
Picture decodePng(ByteView file);
/// Radiance RGBE, divided by its EXPOSURE. Throws FormatError.
Picture decodeHdr(ByteView file);
/// By what the file starts with: PNG, HDR, JPEG, BMP or TGA, the last three as a PNG of 8 bits. Throws
/// FormatError.
Picture decodePicture(ByteView file);

} // namespace vkpt::decode
