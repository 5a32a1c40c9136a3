#include "film/stb.h"

#include "film/codecs.h"

#include <cstdlib>
#include <limits>
#include <new>

// Only PNG is read: stb's HDR reader (2.27) does not see the end of a file and can then turn for ever.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#include <stb/stb_image.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace vkpt::film {

DecodedPng stbDecodePng(ByteView file) {
  if (file.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw FormatError("larger than 2 GiB, too large for a .png");
  int width = 0, height = 0, channels = 0;
  stbi_us* samples =
      stbi_load_16_from_memory(file.data(), static_cast<int>(file.size()), &width, &height, &channels, 3);
  if (samples == nullptr)
    throw FormatError(std::string("broken PNG: ") + stbi_failure_reason());
  return {width, height, {samples, std::free}};
}

Bytes stbEncodePng(int width, int height, const std::uint8_t* rgb) {
  int size = 0;
  const CBuffer<unsigned char> png(stbi_write_png_to_mem(rgb, 3 * width, width, height, 3, &size), std::free);
  if (!png)
    throw std::bad_alloc();
  return {png.get(), png.get() + size};
}

void stbWriteHdr(AtomicFile& out, int width, int height, const float* rgb) {
  const auto put = [](void* context, void* data, int size) {
    static_cast<AtomicFile*>(context)->write(
        {static_cast<unsigned char*>(data), static_cast<std::size_t>(size)});
  };
  stbi_write_hdr_to_func(put, &out, width, height, 3, rgb);
}

} // namespace vkpt::film
