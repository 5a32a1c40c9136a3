// The estimator. Radiance in W m^-2 sr^-1; beta is the product of f cos / pdf over the path's vertices.

struct Path {
  Ray ray;          // to the next vertex
  Vec3 beta;
  Vec3 L;           // what the path has gathered
  uint bounce;      // scattering events so far: the next vertex's index
  bool emit;        // whether emission at the next vertex counts: nothing has sampled it yet
  uint pixel;       // with sampleLow and key: the counter of the random numbers
  uint sampleLow;
  uint key;
};

struct Surface {
  Vec3 p;
  Vec3 error;
  Vec3 ng;     // geometric normal on the viewer's side
  Vec3 n;      // shading normal on the viewer's side
  bool front;  // seen from the side its normal points to
  Material m;
};

Surface surfaceAt(Hit hit, Vec3 wo) {
  Surface s;
  TriangleRecord tri = triangleRecord(hit.triangle);
  Float b0 = 1.0 - hit.b1 - hit.b2;
  s.p = tri.v0 * b0 + tri.v1 * hit.b1 + tri.v2 * hit.b2;
  s.error = positionError(tri.v0, tri.v1, tri.v2);
  s.ng = normalize(cross(tri.v1 - tri.v0, tri.v2 - tri.v0));
  s.front = dot(s.ng, wo) > 0.0;
  s.ng = s.front ? s.ng : -s.ng;
  s.n = s.ng;
  if (kEffectSmoothNormals) {
    Vec3 n = triangleNormal(hit.triangle, 0u) * b0 + triangleNormal(hit.triangle, 1u) * hit.b1 +
             triangleNormal(hit.triangle, 2u) * hit.b2;
    n = dot(n, s.ng) < 0.0 ? -n : n;
    // A shading normal that the viewer can't see can't shade: the geometric one stands in.
    if (dot(n, wo) > 0.0) s.n = normalize(n);
  }
  s.m = material(tri.material);
  return s;
}

BsdfSample sampleBsdf(Surface s, Vec3 wo, UVec4 random) {
  BsdfSample b;
  b.wi = s.ng;
  b.weight = Vec3(0.0);
  b.specular = false;
  if (kEffectDiffuse && s.m.bsdf == kBsdfDiffuse) {
    b = sampleDiffuse(s.m, s.n, s.ng, Vec2(toUnit(random.x), toUnit(random.y)));
  }
  if (kEffectMirror && s.m.bsdf == kBsdfMirror) b = sampleMirror(s.m, wo, s.n, s.ng);
  if (kEffectGlass && s.m.bsdf == kBsdfDielectric) {
    b = sampleDielectric(s.m, wo, s.n, s.ng, s.front, toUnit(random.z));
  }
  if (kEffectMetal && s.m.bsdf == kBsdfConductor) b = sampleConductor(s.m, wo, s.n, s.ng);
  return b;
}

// Radiance that the emitters send to a diffuse surface and on to the viewer, by one light sample:
// f cos Le cos' / (r^2 pdf_A).
Vec3 sampleDirect(Surface s, UVec4 random) {
  LightSample light = sampleLight(random);
  Vec3 toLight = light.p - s.p;
  Vec3 origin = offsetRayOrigin(s.p, s.error, s.ng, toLight);
  Vec3 end = offsetRayOrigin(light.p, light.error, light.ng, -toLight);
  Float r2 = dot(toLight, toLight);
  Vec3 wi = toLight / sqrt(r2);
  Float cosLight = MUTATE(BackSampled, -dot(light.ng, wi), abs(dot(light.ng, wi)));
  Float cosSurface = dot(s.n, wi);
  bool facing = cosLight > 0.0 && cosSurface > 0.0 && dot(s.ng, wi) > 0.0 && s.m.bsdf == kBsdfDiffuse;
  Vec3 span = end - origin;
  Float distance = length(span);
  Ray shadow;
  shadow.o = origin;
  shadow.d = span / distance;
  shadow.exclude = kNoTriangle;
  bool visible = facing && MUTATE(OcclusionIgnored,
                                  !traceOccluded(shadow, facing ? distance : 0.0, light.triangle), true);
  Float cosines = MUTATE(SurfaceCosineDropped, cosSurface, 1.0) * MUTATE(LightCosineDropped, cosLight, 1.0);
  Float falloff = MUTATE(DistanceNotSquared, r2, sqrt(r2));
  return visible ? diffuseF(s.m) * light.L * (cosines / (falloff * light.pdf_A)) : Vec3(0.0);
}

// Extends the path by one vertex. Returns whether it goes on.
bool Li(INOUT(Path) path) {
  Hit hit = traceClosest(path.ray);
  Vec3 wo = -path.ray.d;
  bool goesOn = hit.triangle != kNoTriangle;
  if (!goesOn) {
    if (kEffectBackground) path.L += path.beta * MUTATE(BackgroundTwice, background(), 2.0 * background());
  } else {
    Surface s = surfaceAt(hit, wo);

    // EMISSION: L += beta Le, unless the vertex before has sampled the emitters itself.
    if (kEffectAreaLights && path.emit && MUTATE(BackEmits, s.front, true)) {
      path.L += MUTATE(ThroughputDropped, path.beta, Vec3(1.0)) * s.m.emission;
    }
    uint bounceLimit = MUTATE(BounceLimitOffByOne, maxBounces(), maxBounces() + 1u);
    if (kEffectBounceLimit && path.bounce >= bounceLimit) goesOn = false;

    // DIRECT: next event estimation at diffuse surfaces.
    if (kEffectLightSampling && goesOn) {
      UVec4 lightRandom = randomBlock(path.pixel, path.sampleLow, blockLight(path.bounce), path.key);
      path.L += MUTATE(DirectThroughputDropped, path.beta, Vec3(1.0)) * sampleDirect(s, lightRandom);
    }

    // INDIRECT: one direction from the BSDF; the emission it finds counts if no light sample could have found it.
    UVec4 random = randomBlock(path.pixel, path.sampleLow, blockBsdf(path.bounce), path.key);
    BsdfSample b = sampleBsdf(s, wo, random);
    Vec3 beta = path.beta * b.weight;
    path.emit = MUTATE(EmissionTwice, b.specular || !kEffectLightSampling, true);
    path.ray.o = offsetRayOrigin(s.p, s.error, s.ng, b.wi);
    path.ray.d = b.wi;
    path.ray.exclude = hit.triangle;
    path.bounce += 1u;

    // ROULETTE: survivors stand for those that ended. The probability has no cap below 1, which would give
    // closed bright scenes an infinite variance.
    Float survivalProbability = 1.0;
    if (kEffectRoulette && path.bounce >= rouletteAfter()) {
      survivalProbability =
          min(1.0, kRouletteMode == kRouletteAlbedo ? meanComponent(b.weight) : maxComponent(beta));
    }
    bool survives = toUnit(random.w) < MUTATE(RouletteCapped, survivalProbability, min(survivalProbability, 0.5));
    goesOn = goesOn && maxComponent(beta) > 0.0 && survives;
    path.beta = beta / MUTATE(SurvivalNotDivided, survivalProbability, 1.0);
    if (kEffectBounceLimit && path.bounce >= bounceLimit && !path.emit) goesOn = false;
    if (goesOn && path.bounce >= kBounceCap) {
      reportCappedPath();
      goesOn = false;
    }
  }
  return goesOn;
}
