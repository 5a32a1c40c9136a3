// The pinhole camera: a ray through a point of a pixel, or about it as the reconstruction filter has it.

Path cameraPath(uint pixel, uint x, uint y, uint sampleLow, uint key) {
  UVec4 random = randomBlock(pixel, sampleLow, kBlockCamera, key);
  Float px = Float(x) + MUTATE(PixelNotJittered, toUnit(random.x), 0.5);
  Float py = Float(y) + toUnit(random.y);
  Path path;
  path.sampleWeight = 1.0;
  if (kEffectPixelFilter) {
    FilterSample fx = sampleFilter(toUnit(random.x));
    FilterSample fy = sampleFilter(toUnit(random.y));
    px = Float(x) + 0.5 + fx.offset;
    py = Float(y) + 0.5 + fy.offset;
    path.sampleWeight = fx.weight * fy.weight;
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
  path.otherPdf_A = 0.0;
  path.from = path.ray.o;
  path.fromNormal = Vec3(0.0);
  path.fromTable = 0u;
  path.reuse = kReuseNone;
  path.branch = 0u;
  path.waiting = 0u;
  path.repeat = 0u;
  path.repeats = 1u;
  path.pixel = pixel;
  path.sampleLow = sampleLow;
  path.key = key;
  return path;
}

// The next of a sample's paths, if there is one; what they gather adds up. fresh: the start of the first of them.
bool startAgainFrom(Path fresh, INOUT(Path) path) {
  uint next = path.repeat + 1u;
  bool again = kEffectSpecularSamples && next < path.repeats;
  if (again) {
    Path last = path;
    path = fresh;
    path.L = last.L;
    path.sampleWeight = last.sampleWeight;
    path.repeats = last.repeats;
    path.repeat = next;
  }
  return again;
}
bool startAgain(INOUT(Path) path) {
  uint x = path.pixel % imageWidth();
  uint y = path.pixel / imageWidth();
  Path fresh = cameraPath(path.pixel, x, y, path.sampleLow, path.key);
  return startAgainFrom(fresh, path);
}

// What a finished sample adds to its pixel, unless pixels share paths.
Vec3 sampleValue(Path path) { return kEffectPixelFilter || kEffectSpecularSamples ? path.L * path.sampleWeight : path.L; }
// What is known of a sample when its path has ended: its value, or what is shared of it.
Vec3 finishedLight(Path path) { return reusesPaths() ? path.L : sampleValue(path); }
