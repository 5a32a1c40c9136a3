#include "decode/stb.h"

#include "decode/jpeg_check.h"
#include "decode/samples.h"

#include <cstdlib>
#include <limits>
#include <string>

// No HDR: stb's reader (2.27) does not see the end of a file and can then turn for ever.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
// GCC does not see that what reads from memory never asks for a callback's buffer.
#ifndef __clang__ // which has no such warning
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <stb/stb_image.h>
#ifndef __clang__
#pragma GCC diagnostic pop
#endif

namespace vkpt::decode {

namespace {

constexpr std::size_t kMostBytes = std::numeric_limits<int>::max();

void checkSize(ByteView file, std::size_t pixels) {
  // stb's sizes of 16-bit samples would overflow.
  if (pixels > kMostBytes / (3 * sizeof(stbi_us)))
    throw FormatError("too many pixels");
  // It takes what is missing for zeros, of a PNG excepted. A blank progressive JPEG has 341 pixels in a byte.
  constexpr std::size_t kMostPixelsPerByte = 1024;
  if (!startsAsPng(file) && pixels / kMostPixelsPerByte > file.size())
    throw FormatError("broken image: the file ends too soon");
}

} // namespace

Samples stbDecode(ByteView file) {
  if (file.size() > kMostBytes)
    throw FormatError("larger than 2 GiB, too large for an image");
  checkJpeg(file);
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(file.data(), static_cast<int>(file.size()), &width, &height, &channels) != 0)
    checkSize(file, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  stbi_us* samples =
      stbi_load_16_from_memory(file.data(), static_cast<int>(file.size()), &width, &height, &channels, 3);
  if (samples == nullptr)
    throw FormatError(std::string("broken image: ") + stbi_failure_reason());
  return {width, height, {samples, std::free}};
}

} // namespace vkpt::decode
