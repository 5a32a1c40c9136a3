#include "unit/scene/image_bytes.h"

#include <stdexcept>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace vkpt::test {

std::string imageBytes(std::string_view format, int width, int height, const std::vector<std::uint8_t>& rgb) {
  std::string bytes;
  const auto put = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<char*>(data), static_cast<std::size_t>(size));
  };
  constexpr int kBestQuality = 100;
  int done = 0;
  if (format == "png") {
    done = stbi_write_png_to_func(put, &bytes, width, height, 3, rgb.data(), 3 * width);
  } else if (format == "jpg") {
    done = stbi_write_jpg_to_func(put, &bytes, width, height, 3, rgb.data(), kBestQuality);
  } else if (format == "bmp") {
    done = stbi_write_bmp_to_func(put, &bytes, width, height, 3, rgb.data());
  } else if (format == "tga") {
    done = stbi_write_tga_to_func(put, &bytes, width, height, 3, rgb.data());
  }
  if (done == 0) {
    throw std::runtime_error("no image of format " + std::string(format));
  }
  return bytes;
}

std::string hdrRow(int width, std::initializer_list<std::uint8_t> rgbe, std::string_view header) {
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n";
  bytes.append(header).append("\n-Y 1 +X ").append(std::to_string(width)).append("\n");
  for (const std::uint8_t byte : rgbe) {
    bytes.push_back(static_cast<char>(byte));
  }
  return bytes;
}

} // namespace vkpt::test
