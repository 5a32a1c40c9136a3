// The pinhole camera: a ray through a uniformly chosen point of a pixel (box filter).

Path cameraPath(uint pixel, uint x, uint y, uint sampleLow, uint key) {
  UVec4 random = randomBlock(pixel, sampleLow, kBlockCamera, key);
  Float u = (Float(x) + MUTATE(PixelNotJittered, toUnit(random.x), 0.5)) * inverseWidth();
  Float v = (Float(y) + toUnit(random.y)) * inverseHeight();
  Path path;
  path.ray.o = cameraEye();
  path.ray.d = normalize(cameraUpperLeft() + cameraRight() * u + cameraDown() * MUTATE(ImageFlipped, v, 1.0 - v));
  path.ray.exclude = kNoTriangle;
  path.beta = Vec3(1.0);
  path.L = Vec3(0.0);
  path.bounce = 0u;
  path.emit = true;
  path.pixel = pixel;
  path.sampleLow = sampleLow;
  path.key = key;
  return path;
}
