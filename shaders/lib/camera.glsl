// The pinhole camera: a ray through a point of a pixel, or about it as the reconstruction filter has it.

Path cameraPath(uint pixel, uint x, uint y, uint sampleLow, uint key) {
  UVec4 random = randomBlock(pixel, sampleLow, kBlockCamera, key);
  Float px = Float(x) + MUTATE(PixelNotJittered, toUnit(random.x), 0.5);
  Float py = Float(y) + toUnit(random.y);
  Path path;
  path.filterWeight = 1.0;
  if (kEffectPixelFilter) {
    FilterSample fx = sampleFilter(toUnit(random.x));
    FilterSample fy = sampleFilter(toUnit(random.y));
    px = Float(x) + 0.5 + fx.offset;
    py = Float(y) + 0.5 + fy.offset;
    path.filterWeight = fx.weight * fy.weight;
  }
  Float u = px * inverseWidth();
  Float v = py * inverseHeight();
  path.ray.o = cameraEye();
  path.ray.d = normalize(cameraUpperLeft() + cameraRight() * u + cameraDown() * MUTATE(ImageFlipped, v, 1.0 - v));
  path.ray.exclude = kNoTriangle;
  path.beta = Vec3(1.0);
  path.L = Vec3(0.0);
  path.bounce = 0u;
  path.emit = true;
  path.pdf_w = 0.0;
  path.history = kHistoryEye;
  path.branch = 0u;
  path.waiting = 0u;
  path.pixel = pixel;
  path.sampleLow = sampleLow;
  path.key = key;
  return path;
}

// What a finished path adds to its pixel.
Vec3 sampleValue(Path path) { return kEffectPixelFilter ? path.L * path.filterWeight : path.L; }
