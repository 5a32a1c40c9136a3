#include "film/display.h"

#include <algorithm>
#include <cmath>

namespace vkpt::film {

double srgbEncode(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double acesFilmic(double x) {
  const double bounded = std::min(x, 1e100); // infinity has the limit's value
  return (bounded * (2.51 * bounded + 0.03)) / (bounded * (2.43 * bounded + 0.59) + 0.14);
}

DisplayTransform::DisplayTransform(const DisplaySettings& settings)
    : m_scale(std::exp2(settings.exposureStops)), m_tonemap(settings.tonemap) {}

unsigned char DisplayTransform::byte(float radiance) const {
  double v = static_cast<double>(radiance) * m_scale;
  if (!(v > 0.0)) // NaN too
    return 0;
  if (m_tonemap == Tonemap::Aces)
    v = acesFilmic(v);
  v = std::min(v, 1.0);
  if (m_tonemap != Tonemap::None)
    v = srgbEncode(v);
  return static_cast<unsigned char>(std::lround(255.0 * v));
}

} // namespace vkpt::film
