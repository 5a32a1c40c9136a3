// Reconstruction filters: the position of a sample about its pixel's centre is sampled in proportion to the
// filter's size, and the sample weighted by what is left, the sign above all. One axis at a time.

struct FilterSample {
  Float offset; // pixels
  Float weight; // expectation 1
};

// The filter at x pixels from the centre, integral 1. shape.x radius, shape.y factor that makes the integral 1,
// shape.zw: gaussian: 1 / (2 stddev^2), value at the radius; mitchell: B, C (Mitchell and Netravali 1988, eq. 8,
// stretched to the radius).
Float filterValue(Float x) {
  Vec4 shape = filterShape();
  Float r = abs(x);
  Float value = 1.0;
  if (kFilterShape == kFilterTent) value = max(shape.x - r, 0.0);
  if (kFilterShape == kFilterGaussian) value = max(exp(-r * r * shape.z) - shape.w, 0.0);
  if (kFilterShape == kFilterMitchell) {
    Float t = 2.0 * r / shape.x;
    Float b = shape.z;
    Float c = shape.w;
    Float inner = (12.0 - 9.0 * b - 6.0 * c) * t * t * t + (-18.0 + 12.0 * b + 6.0 * c) * t * t + (6.0 - 2.0 * b);
    Float outer = (-b - 6.0 * c) * t * t * t + (6.0 * b + 30.0 * c) * t * t + (-12.0 * b - 48.0 * c) * t +
                  (8.0 * b + 24.0 * c);
    value = t < 1.0 ? inner : (t < 2.0 ? outer : 0.0);
  }
  return value * shape.y;
}

// A bin of equal probability, and within it a position by the trapezium under the filter's sizes at its edges.
FilterSample sampleFilter(Float u) {
  Float scaled = u * Float(kFilterBins);
  uint bin = uint(scaled);
  Float v = scaled - Float(bin) + 1.9073486328125e-6; // in (0, 1): half a step of what is left of 24 bits
  Float a = filterEdge(bin);
  Float b = filterEdge(bin + 1u);
  Float fa = abs(filterValue(a));
  Float fb = abs(filterValue(b));
  Float t = v * (fa + fb) / (fa + sqrt(fa * fa + v * (fb * fb - fa * fa)));
  FilterSample s;
  s.offset = a + (b - a) * t;
  Float pdf = 2.0 * (fa + (fb - fa) * t) / ((fa + fb) * (b - a) * Float(kFilterBins));
  s.weight = MUTATE(FilterSignDropped, filterValue(s.offset), abs(filterValue(s.offset))) / pdf;
  return s;
}
