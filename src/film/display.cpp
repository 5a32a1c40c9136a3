#include "film/display.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/glm.hpp>

namespace vkpt::film {

/// The device's formulas in double.
namespace host64 {
using Float = double;
#include "shared/language.h"

#include "lib/display.glsl"
} // namespace host64

static_assert(host64::kTonemapNone == static_cast<unsigned>(Tonemap::None));
static_assert(host64::kTonemapSrgb == static_cast<unsigned>(Tonemap::Srgb));
static_assert(host64::kTonemapAces == static_cast<unsigned>(Tonemap::Aces));

double srgbEncode(double linear) { return host64::srgbEncode(linear); }
double acesFilmic(double x) { return host64::acesFilmic(x); }

DisplayTransform::DisplayTransform(const DisplaySettings& settings)
    : m_scale(std::exp2(settings.exposureStops)), m_tonemap(settings.tonemap) {}

unsigned char DisplayTransform::byte(float radiance) const {
  return static_cast<unsigned char>(
      host64::displayByte(static_cast<double>(radiance), m_scale, static_cast<unsigned>(m_tonemap)));
}

} // namespace vkpt::film
