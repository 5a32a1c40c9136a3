// Colour textures: bilinear between the centres of pixels, repeated in both directions.

// Row 0 is at the top, v runs upwards.
Vec3 textureAt(uint index, Vec2 uv) {
  TextureRecord t = textureRecord(index);
  Float x = (uv.x - floor(uv.x)) * Float(t.width) - 0.5;
  Float y = MUTATE(TextureFlipped, 1.0 - (uv.y - floor(uv.y)), uv.y - floor(uv.y)) * Float(t.height) - 0.5;
  Float fx = x - floor(x);
  Float fy = y - floor(y);
  uint x0 = uint(floor(x) + Float(t.width)) % t.width;
  uint y0 = uint(floor(y) + Float(t.height)) % t.height;
  uint x1 = (x0 + 1u) % t.width;
  uint y1 = (y0 + 1u) % t.height;
  Vec3 upper = mix(texturePixel(t.first + y0 * t.width + x0), texturePixel(t.first + y0 * t.width + x1), fx);
  Vec3 lower = mix(texturePixel(t.first + y1 * t.width + x0), texturePixel(t.first + y1 * t.width + x1), fx);
  return mix(upper, lower, fy);
}
