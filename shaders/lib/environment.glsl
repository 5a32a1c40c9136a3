// The environment map: radiance constant over each texel of latitude and longitude, light from infinitely far.

struct EnvironmentSample {
  Vec3 wi; // unit, towards the light
  Vec3 L;
  Float pdf_w; // over solid angle, given that light sampling chooses the environment
};

// Texel that direction d (unit) lies in. By atan, which drivers approximate better than acos.
EnvironmentRecord environmentAt(Vec3 d) {
  Float theta = atan(sqrt(d.x * d.x + d.z * d.z), d.y);
  Float phi = atan(d.x, -d.z) + kPi;
  uint row = min(uint(theta * kInvPi * Float(environmentHeight())), environmentHeight() - 1u);
  uint column = min(uint(phi * (0.5 * kInvPi) * Float(environmentWidth())), environmentWidth() - 1u);
  return environmentRecord(row * environmentWidth() + column);
}

// A texel in proportion to what it emits, by Walker's alias table, and a direction uniform over its solid angle.
EnvironmentSample sampleEnvironment(UVec4 random) {
  uint i = multiplyHigh(random.x, environmentWidth() * environmentHeight());
  EnvironmentRecord texel = environmentRecord(i);
  if (!(toUnit(random.y) < MUTATE(EnvironmentAliasIgnored, texel.threshold, 2.0))) {
    i = texel.alias;
    texel = environmentRecord(i);
  }
  Float perRow = kPi / Float(environmentHeight());
  Float row = Float(i / environmentWidth());
  Float upper = cos(perRow * row);
  Float lower = cos(perRow * (row + 1.0));
  Float y = MUTATE(EnvironmentSineDropped, upper + (lower - upper) * toUnit(random.z),
                   cos(perRow * (row + toUnit(random.z))));
  Float sinTheta = sqrt(max(1.0 - y * y, 0.0));
  Float phi = 2.0 * kPi * ((Float(i % environmentWidth()) + toUnit(random.w)) / Float(environmentWidth()) - 0.5);
  EnvironmentSample s;
  s.wi = Vec3(sinTheta * sin(phi), y, -sinTheta * cos(phi));
  s.L = texel.radiance;
  s.pdf_w = texel.pdf_w;
  return s;
}
