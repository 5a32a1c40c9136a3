// Light sampling: a point on an emissive triangle, chosen in proportion to power.

struct LightSample {
  Vec3 p;
  Vec3 error;    // as positionError()
  Vec3 ng;       // of the emitting side
  Vec3 L;        // radiance
  Float pdf_A;   // 1/m^2: choice of the triangle times 1/area
  uint triangle; // in BVH order
};

// One texel of each record holds a row of Walker's alias table (Walker 1977; Vose 1991): the integer part of the
// choice picks a row, a second number its owner or its alias.
LightSample sampleLight(UVec4 random) {
  uint index = 0u;
  if (kEffectManyLights) {
    uint row = multiplyHigh(random.x, lightCount());
    index = MUTATE(AliasIgnored, toUnit(random.y) < lightRecord(row).threshold, true) ? row : lightRecord(row).alias;
  }
  LightRecord light = lightRecord(index);
  Vec2 b = squareToTriangle(Vec2(toUnit(random.z), toUnit(random.w)));
  Vec3 n = cross(light.v1 - light.v0, light.v2 - light.v0);
  Float doubleArea = length(n);
  LightSample s;
  s.p = light.v0 + (light.v1 - light.v0) * b.x + (light.v2 - light.v0) * b.y;
  s.error = positionError(light.v0, light.v1, light.v2);
  s.ng = n / doubleArea;
  s.L = light.radiance;
  s.pdf_A = MUTATE(LightChoiceDropped, light.probability, 1.0) * MUTATE(LightAreaDropped, 2.0 / doubleArea, 1.0);
  s.triangle = light.triangle;
  return s;
}
