#pragma once
// From linear radiance to the bytes of a display, and back.

#include "decode/srgb.h"
#include "film/image.h"

namespace vkpt::film {

/// The sRGB transfer curve and its inverse, IEC 61966-2-1; meant for [0, 1].
double srgbEncode(double linear);
using decode::srgbDecode;

/// K. Narkowicz 2016, "ACES Filmic Tone Mapping Curve" (knarkowicz.wordpress.com): a rational fit, per
/// channel, of the ACES reference and output transforms for an sRGB display, without the factor 0.6 of the
/// original exposure. For x >= 0; tends to 2.51 / 2.43.
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
