// Radiance RGBE (G. Ward 1991, "Real Pixels", Graphics Gems II): written through stb.

#include "film/codecs.h"
#include "film/stb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vkpt::film {

namespace {

constexpr int kMantissaBits = 8;
constexpr int kHighestExponent = 127;

/// The colour that RGBE holds which is nearest to `rgb`: stb would cut off, and so lose up to 1/128 of a
/// channel.
void roundToRgbe(float* rgb) {
  const double most = std::ldexp(255.0, kHighestExponent - kMantissaBits);
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    rgb[c] = rgb[c] > 0.0F ? static_cast<float>(std::min<double>(rgb[c], most)) : 0.0F; // NaN too
    largest = std::max<double>(largest, rgb[c]);
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  if (std::nearbyint(std::ldexp(largest, kMantissaBits - exponent)) == 256.0)
    ++exponent;
  for (int c = 0; c < 3; ++c) {
    const double mantissa = std::nearbyint(std::ldexp(static_cast<double>(rgb[c]), kMantissaBits - exponent));
    rgb[c] = static_cast<float>(std::ldexp(mantissa, exponent - kMantissaBits));
  }
}

} // namespace

void checkHdrSize(int width, int height) {
  const auto floats = 3 * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  if (floats > static_cast<std::uint64_t>(std::numeric_limits<int>::max()) || width > (1 << 24))
    throw UsageError(fmt::format("{}x{} pixels are too many for .hdr; use .exr or .pfm", width, height));
}

void writeHdr(AtomicFile& out, const Image& image) {
  checkHdrSize(image.width, image.height);
  const auto planes = colourPlanes(image);
  std::vector<float> rgb(3 * image.pixelCount());
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      rgb[3 * i + c] = planes[c][i];
    roundToRgbe(&rgb[3 * i]);
  }
  stbWriteHdr(out, image.width, image.height, rgb.data());
}

Image decodeHdr(ByteView file) { return planesOf(decode::decodeHdr(file)); }

} // namespace vkpt::film
