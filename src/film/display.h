#pragma once
// From linear radiance to the bytes of a display (shaders/lib/display.glsl in double), and back.

#include "decode/srgb.h"
#include "film/image.h"

namespace vkpt::film {

/// The sRGB transfer curve and its inverse, IEC 61966-2-1; meant for [0, 1].
double srgbEncode(double linear);
using decode::srgbDecode;

/// Narkowicz's fit of the ACES curve, without the sRGB curve behind it.
double acesFilmic(double x);

/// One channel's linear radiance as a byte; total: NaN and what is below 0 give 0, what is above 1 gives 255.
class DisplayTransform {
public:
  explicit DisplayTransform(const DisplaySettings& settings);
  [[nodiscard]] unsigned char byte(float radiance) const;

private:
  double m_scale;
  Tonemap m_tonemap;
};

} // namespace vkpt::film
