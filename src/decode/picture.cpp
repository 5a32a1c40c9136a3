#include "decode/picture.h"

#include "decode/samples.h"
#include "decode/srgb.h"

namespace vkpt::decode {

Picture linearPicture(const Samples& samples) {
  Picture picture{samples.width, samples.height, {}};
  picture.rgb.resize(3 * picture.pixelCount());
  for (std::size_t i = 0; i < picture.rgb.size(); ++i)
    picture.rgb[i] = static_cast<float>(srgbDecode(samples.rgb[i] / 65535.0));
  return picture;
}

Picture decodePicture(ByteView file) {
  if (startsAsPng(file))
    return decodePng(file);
  if (file.size() >= 2 && file[0] == '#' && file[1] == '?')
    return decodeHdr(file);
  return linearPicture(stbDecode(file));
}

} // namespace vkpt::decode
