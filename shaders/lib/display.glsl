// From linear radiance to the bytes of a display. The host writes PNG files by it, the device draws windows.

CONSTANT uint kTonemapNone = 0u; // the values of vkpt::Tonemap
CONSTANT uint kTonemapSrgb = 1u;
CONSTANT uint kTonemapAces = 2u;

// The sRGB transfer curve, IEC 61966-2-1; meant for [0, 1].
Float srgbEncode(Float linear) { return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055; }

// K. Narkowicz 2016, "ACES Filmic Tone Mapping Curve" (knarkowicz.wordpress.com): a rational fit, per channel, of
// the ACES reference and output transforms for an sRGB display, without the factor 0.6 of the original exposure.
// For x >= 0; tends to 2.51 / 2.43, which numbers whose square could overflow have.
Float acesFilmic(Float x) {
  Float bounded = min(x, 1e15);
  return (bounded * (2.51 * bounded + 0.03)) / (bounded * (2.43 * bounded + 0.59) + 0.14);
}

// One channel's byte: scale is 2^exposure. Total: NaN and what is below 0 give 0, what is above 1 gives 255.
uint displayByte(Float radiance, Float scale, uint tonemap) {
  Float v = radiance * scale;
  bool lit = v > 0.0; // NaN is not
  v = lit ? v : 0.0;
  if (tonemap == kTonemapAces) v = acesFilmic(v);
  v = min(v, 1.0);
  if (tonemap != kTonemapNone) v = srgbEncode(v);
  return uint(floor(255.0 * v + 0.5));
}
