#pragma once
// Small image files, made by stb_image_write or by hand.

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt::test {

/// `format`: png, jpg, bmp or tga. `rgb`: 8-bit samples, row by row from the top.
std::string imageBytes(std::string_view format, int width, int height, const std::vector<std::uint8_t>& rgb);

/// A Radiance file of one row; `rgbe`: four bytes a pixel.
std::string hdrRow(int width, std::initializer_list<std::uint8_t> rgbe, std::string_view header = {});

} // namespace vkpt::test
