#include "film/stb.h"

#include <cstdlib>
#include <new>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace vkpt::film {

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
