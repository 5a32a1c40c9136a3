// Light sampling: a light chosen in proportion to its power or by the tree, and a direction to it.

struct LightSample {
  Vec3 wi; // unit, towards the light
  Vec3 L;  // radiance; of delta lights the irradiance of a surface that faces it
  Float pdf_w; // over solid angle, choice included; of delta lights the choice alone; 0: the light's back
  bool delta;
  bool distant; // infinitely far
  Vec3 end;        // of the shadow ray, unless distant
  uint triangle; // in BVH order: what the shadow ray may meet
};

// One texel of each record holds a row of Walker's alias table (Walker 1977; Vose 1991): the integer part of the
// choice picks a row, its fraction the owner or the alias, and what is left of that a point on the light: so the points
// of all lights together are as well spread as random.z and random.w. random.x has the bits that many lights use up.
LightRecord chooseByPower(UVec4 random, OUT(Vec2) point) {
  uint index = 0u;
  point = Vec2(toUnit(random.z), toUnit(random.w));
  if (kEffectManyLights) {
    uint row = multiplyHigh(random.z, lightCount());
    uint low = random.z * lightCount();
    uint fraction = low + multiplyHigh(random.x, lightCount());
    row += fraction < low ? 1u : 0u; // stays below: the last row has no carry
    Float threshold = lightRecord(row).threshold;
    Float u = toUnit(fraction);
    bool owner = MUTATE(AliasIgnored, u < threshold, true);
    index = owner ? row : lightRecord(row).alias;
    point.x = owner ? u / threshold : (u - threshold) / (1.0 - threshold);
  }
  return lightRecord(index);
}

// Density over solid angle of a point sampled with pdf_A on a surface, at a distance and an angle.
Float areaToSolidAngle(Float pdf_A, Float r2, Float cosLight) { return pdf_A * r2 / cosLight; }

// A point on an emissive triangle, uniform over its area.
LightSample sampleTriangle(LightRecord light, Vec3 p, Vec2 u) {
  Vec2 b = squareToTriangle(u);
  Vec3 n = cross(light.v1 - light.v0, light.v2 - light.v0);
  Float doubleArea = length(n);
  Vec3 ng = n / doubleArea;
  Vec3 onLight = light.v0 + (light.v1 - light.v0) * b.x + (light.v2 - light.v0) * b.y;
  Vec3 toLight = onLight - p;
  Float r2 = dot(toLight, toLight);
  LightSample s;
  s.wi = toLight / sqrt(r2);
  s.L = light.radiance;
  Float cosLight = MUTATE(BackSampled, -dot(ng, s.wi), abs(dot(ng, s.wi)));
  Float pdf_A = MUTATE(LightChoiceDropped, light.probability, 1.0) * MUTATE(LightAreaDropped, 2.0 / doubleArea, 1.0);
  s.pdf_w = cosLight > 0.0 ? areaToSolidAngle(pdf_A, MUTATE(DistanceNotSquared, r2, sqrt(r2)),
                                              MUTATE(LightCosineDropped, cosLight, 1.0))
                           : 0.0;
  s.delta = false;
  s.distant = false;
  s.end = offsetRayOrigin(onLight, positionError(light.v0, light.v1, light.v2), ng, -toLight);
  return s;
}

// Seen from p, a surface of normal n (0: that scatters on both sides). `random` chooses the light and a point on it,
// `more` a direction to the environment.
LightSample sampleLight(Vec3 p, Vec3 n, UVec4 random, UVec4 more) {
  Vec2 point;
  LightRecord light = choosesByTree() ? chooseByTree(p, n, random, point) : chooseByPower(random, point);
  LightSample s;
  s.wi = Vec3(0.0, 0.0, 1.0);
  s.L = Vec3(0.0);
  s.pdf_w = 0.0; // of a light whose kind is left out
  s.delta = false;
  s.distant = false;
  s.end = p;
  if (kEffectAreaLights) s = sampleTriangle(light, p, point);
  s.triangle = light.triangle;
  if (kEffectDeltaLights && (light.triangle == kLightPoint || light.triangle == kLightDirectional)) {
    s.distant = light.triangle == kLightDirectional;
    Vec3 toLight = s.distant ? light.v0 : light.v0 - p;
    Float r2 = dot(toLight, toLight);
    s.wi = toLight / sqrt(r2);
    s.L = s.distant ? light.radiance : light.radiance / MUTATE(PointFalloffDropped, r2, 1.0);
    s.pdf_w = MUTATE(LightChoiceDropped, light.probability, 1.0);
    s.delta = true;
    s.end = light.v0;
  }
  if (kEffectEnvironment && light.triangle == kLightEnvironment) {
    EnvironmentSample e = sampleEnvironment(more);
    s.wi = e.wi;
    s.L = e.L;
    s.pdf_w = e.pdf_w * MUTATE(LightChoiceDropped, light.probability, 1.0);
    s.distant = true;
  }
  return s;
}

// Weight of a strategy of density pdf_w against another one: the power heuristic (Veach 1997, 9.2.4), as a ratio
// since squares overflow.
Float misWeight(Float pdf_w, Float other) {
  Float ratio = other / pdf_w;
  return MUTATE(WeightBySquares, MUTATE(MisWeightDropped, 1.0 / (1.0 + ratio * ratio), 1.0),
                pdf_w * pdf_w / (pdf_w * pdf_w + other * other));
}
