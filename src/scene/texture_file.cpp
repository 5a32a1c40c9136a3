#include "scene/texture_file.h"

#include "decode/picture.h"

#include <cmath>
#include <fstream>
#include <system_error>

namespace vkpt {

namespace {

decode::Bytes readBytes(const fs::path& path) {
  const SourceLocation where{path.string()};
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw SceneError(where, "no such file");
  }
  if (!fs::is_regular_file(status)) {
    throw SceneError(where, "is no regular file");
  }
  std::ifstream file(path, std::ios::binary);
  decode::Bytes bytes;
  std::vector<char> chunk(1U << 16U);
  while (file.is_open() && (file.read(chunk.data(), std::ssize(chunk)), file.gcount() > 0)) {
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + file.gcount());
  }
  if (!file.is_open() || file.bad()) {
    throw SceneError(where, "cannot be read; check its permissions");
  }
  return bytes;
}

} // namespace

ImageFile readImageFile(const fs::path& path) {
  const decode::Bytes bytes = readBytes(path);
  try {
    const decode::Picture picture = decode::decodePicture(bytes);
    ImageFile image{picture.width, picture.height, {}};
    image.texels.reserve(picture.pixelCount());
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
      const Vec3f texel(picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]);
      // An EXPOSURE can make the values of an HDR file infinite.
      if (!std::isfinite(texel.x) || !std::isfinite(texel.y) || !std::isfinite(texel.z)) {
        throw decode::FormatError("holds values beyond the range of float");
      }
      image.texels.push_back(texel);
    }
    return image;
  } catch (const decode::FormatError& error) {
    throw SceneError({path.string()}, error.what());
  }
}

} // namespace vkpt
