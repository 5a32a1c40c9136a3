// The estimator. Radiance in W m^-2 sr^-1; beta is the product of f cos / pdf over the path's vertices.

struct Path {
  Ray ray;          // to the next vertex
  Vec3 beta;
  Vec3 L;           // what the path has gathered
  uint bounce;      // scattering events so far: the next vertex's index
  bool emit;        // whether emission at the next vertex counts: light sampling has not counted all of it
  Float pdf_w;      // with which the BSDF sampled ray.d where light sampling could too; 0: emission counts in full
  uint history;     // kinds.glsl
  uint branch;      // which branches of split vertices the path has taken, a bit each
  uint waiting;     // branches that wait
  uint pixel;       // with sampleLow and key: the counter of the random numbers
  uint sampleLow;
  uint key;
  Float filterWeight; // of the sample in its pixel
};

UVec4 pathRandom(Path path, uint block) {
  uint key = path.key;
  if (kEffectSplitting) key = branchKey(key, path.branch);
  return randomBlock(path.pixel, path.sampleLow, block, key);
}

bool weighsStrategies() { return kEffectMis && lightStrategy() == kStrategyMis; }
// Whether light sampling finds the emitters that a ray can hit: delta lights alone are sampled in any case.
bool samplesEmitters() { return kEffectLightSampling && lightStrategy() != kStrategyBsdf; }

// Adds light that a path of this history has found.
void gather(INOUT(Path) path, uint history, Vec3 L) {
  Vec3 counted = L;
  if (kEffectPathKinds && !MUTATE(UnwantedKindsCount, kindWanted(history), true)) counted = Vec3(0.0);
  if (kEffectKindImages) recordKind(kindOf(history), counted * path.filterWeight);
  path.L += counted;
}

// What a light sends by way of a vertex to the viewer, if nothing is in between.
struct DirectLight {
  Ray shadow;
  Float end;    // of the shadow ray; 0: no light, no ray
  uint target;  // triangle that the shadow ray leads to
  Vec3 L;
  uint history; // of the path that it makes
};

DirectLight noDirectLight() {
  DirectLight d;
  d.shadow.o = Vec3(0.0);
  d.shadow.d = Vec3(0.0, 0.0, 1.0);
  d.shadow.exclude = kNoTriangle;
  d.end = 0.0;
  d.target = kNoTriangle;
  d.L = Vec3(0.0);
  d.history = kHistoryEye;
  return d;
}

// One light sample: radiance f cos Le / pdf_w.
DirectLight sampleDirect(Surface s, Vec3 wo, UVec4 random, UVec4 more, bool wanted) {
  LightSample light = sampleLight(s.p, random, more);
  Vec3 origin = offsetRayOrigin(s.p, s.error, s.ng, light.wi);
  Vec3 span = light.end - origin;
  Float distance = length(span);
  DirectLight d;
  d.shadow.o = origin;
  d.shadow.d = light.distant ? light.wi : span / distance;
  d.shadow.exclude = kNoTriangle;
  bool facing = wanted && light.pdf_w > 0.0 && isSmooth(s.m.bsdf) && scattersTo(s, light.wi);
  Float end = light.distant ? kFarAway : distance;
  d.end = facing ? end : 0.0;
  d.target = light.triangle;
  BsdfValue bsdf = evaluateBsdf(s, wo, light.wi);
  Float weight = MUTATE(SurfaceCosineDropped, abs(dot(s.n, light.wi)), 1.0) / light.pdf_w;
  if (weighsStrategies() && !light.delta) {
    weight *= misWeight(light.pdf_w, bsdf.pdf_w / Float(kEffectLightSamples ? lightSamples() : 1u));
  }
  d.L = facing ? bsdf.f * light.L * weight : Vec3(0.0);
  d.history = kHistoryEye;
  return d;
}

// Adds it to the path, now that its shadow ray has ended.
void gatherDirect(INOUT(Path) path, DirectLight d, bool occluded) {
  gather(path, d.history, MUTATE(OcclusionIgnored, occluded, false) ? Vec3(0.0) : d.L);
}

// Weight of emission that BSDF sampling has found, where light sampling would have found it with density pdf_w.
Float emissionWeight(Path path, Float lightPdf_w) {
  Float samples = Float(kEffectLightSamples ? MUTATE(MisSamplesIgnored, lightSamples(), 1u) : 1u);
  return weighsStrategies() && path.pdf_w > 0.0 && lightPdf_w > 0.0 ? misWeight(path.pdf_w, samples * lightPdf_w) : 1.0;
}

void saveBranch(INOUT(Path) path, Surface s, Vec3 wi, Vec3 beta, uint triangle, uint history, uint branch) {
  Branch b;
  b.o = offsetRayOrigin(s.p, s.error, s.ng, wi);
  b.exclude = triangle;
  b.d = wi;
  b.branch = branch;
  b.beta = beta;
  b.bounce = path.bounce | (history << 16u);
  storeBranch(path.waiting, b);
  path.waiting += 1u;
}

void resumeBranch(INOUT(Path) path) {
  path.waiting -= 1u;
  Branch b = loadBranch(path.waiting);
  path.ray.o = b.o;
  path.ray.d = b.d;
  path.ray.exclude = b.exclude;
  path.beta = b.beta;
  path.bounce = b.bounce & 0xFFFFu;
  path.history = b.bounce >> 16u;
  path.branch = b.branch;
  path.emit = true;
  path.pdf_w = 0.0;
}

// Light that a path meets as it leaves the scene.
void gatherBackground(INOUT(Path) path) {
  if (kEffectBackground) {
    gather(path, path.history, path.beta * MUTATE(BackgroundTwice, background(), 2.0 * background()));
  }
  if (kEffectEnvironment && path.emit) {
    EnvironmentRecord e = environmentAt(path.ray.d);
    gather(path, path.history, path.beta * e.radiance * emissionWeight(path, e.pdf_w * environmentProbability()));
  }
}

// Extends the path by the vertex that its ray has hit. Returns whether it goes on; what the lights send by way of the
// vertex is `direct`, still to be gathered.
bool extendPath(INOUT(Path) path, Hit hit, OUT(DirectLight) direct) {
  direct = noDirectLight();
  Vec3 wo = -path.ray.d;
  bool goesOn = hit.triangle != kNoTriangle;
  if (!goesOn) {
    gatherBackground(path);
  } else {
    Surface s = surfaceAt(hit, wo);
    if (kEffectAbsorption && !s.front && isGlass(s.m.bsdf)) {
      path.beta = path.beta * exp(-s.m.absorption * hit.t); // the way here lay behind the surface
    }

    // EMISSION: L += beta Le, unless the vertex before has sampled the emitters itself.
    if (kEffectAreaLights && path.emit && MUTATE(BackEmits, s.front, true)) {
      Float weight = emissionWeight(path, areaToSolidAngle(s.m.lightPdf_A, hit.t * hit.t, dot(s.ng, wo)));
      gather(path, path.history, MUTATE(ThroughputDropped, path.beta, Vec3(1.0)) * s.m.emission * weight);
    }
    uint bounceLimit = MUTATE(BounceLimitOffByOne, maxBounces(), maxBounces() + 1u);
    if (kEffectBounceLimit && path.bounce >= bounceLimit) goesOn = false;
    if (kEffectOneSided && !MUTATE(BackScatters, scattersHere(s), true)) goesOn = false;

    // DIRECT: next event estimation at surfaces that are not specular.
    if (kEffectLightSampling && goesOn) {
      uint history = afterDiffuse(path.history);
      bool wanted = !kEffectPathKinds || kindWanted(history);
      uint count = kEffectLightSamples ? lightSamples() : 1u;
      Vec3 beta = MUTATE(DirectThroughputDropped, path.beta, Vec3(1.0));
      Vec3 several = Vec3(0.0); // light samples: their shadow rays don't wait
      uint i = 0u;
      do {
        UVec4 random = pathRandom(path, blockLight(path.bounce, i));
        UVec4 more = random;
        if (kEffectEnvironment) more = pathRandom(path, blockLightPoint(path.bounce, i));
        direct = sampleDirect(s, wo, random, more, wanted);
        if (kEffectLightSamples && !traceOccluded(direct.shadow, direct.end, direct.target)) several += direct.L;
        i += 1u;
      } while (kEffectLightSamples && i < count);
      direct.L = beta * direct.L;
      direct.history = history;
      if (kEffectLightSamples) {
        gather(path, history, beta * (several / Float(MUTATE(LightSamplesNotAveraged, count, 1u))));
        direct = noDirectLight();
      }
    }

    // INDIRECT: one direction from the BSDF; the emission it finds counts as far as no light sample found it.
    UVec4 random = pathRandom(path, blockBsdf(path.bounce));
    BsdfSample b = sampleBsdf(s, wo, random);
    bool specular = b.specular;
    Float total = b.weight.x + b.weight.y + b.weight.z;
    if (!isFinite(total) || (!specular && total > 0.0 && !(b.pdf_w > 0.0 && isFinite(b.pdf_w)))) {
      reportInvalidPdf();
      b.weight = Vec3(0.0);
    }
    Vec3 beta = path.beta * b.weight;
    path.emit = MUTATE(EmissionTwice, specular || !samplesEmitters() || weighsStrategies(), true);
    path.pdf_w = specular ? 0.0 : b.pdf_w;
    uint history = specular ? afterSpecular(path.history, dot(b.wi, s.ng) < 0.0) : afterDiffuse(path.history);
    bool spared = false; // from roulette
    path.bounce += 1u;

    // SPLITTING: at glass the other branch waits, both weighted by their share of the light.
    if (kEffectSplitting && goesOn && path.bounce <= splitDepth()) {
      spared = specular;
      if (s.m.bsdf == kBsdfDielectric) {
        DielectricBranches d = dielectricBranches(s.m, wo, s.n, s.ng, s.front);
        Vec3 refraction = normalize(d.refraction);
        uint transmitted = afterSpecular(path.history, dot(refraction, s.ng) < 0.0);
        if (d.share < 1.0) {
          saveBranch(path, s, refraction, path.beta * (1.0 - d.share), hit.triangle, transmitted, 2u * path.branch + 2u);
        }
        b.wi = normalize(d.reflection);
        beta = path.beta * MUTATE(SplitUnweighted, d.share, 1.0);
        history = afterSpecular(path.history, false);
        path.branch = 2u * path.branch + 1u;
      }
    }
    path.ray.o = offsetRayOrigin(s.p, s.error, s.ng, b.wi);
    path.ray.d = b.wi;
    path.ray.exclude = hit.triangle;
    path.history = history;

    // ROULETTE: survivors stand for those that ended. The probability has no cap below 1, which would give
    // closed bright scenes an infinite variance.
    Float survivalProbability = 1.0;
    if (kEffectRoulette && path.bounce >= rouletteAfter() && !spared) {
      survivalProbability = min(1.0, kRouletteMode == kRouletteAlbedo ? meanComponent(b.weight) : maxComponent(beta));
      if (kRouletteMode == kRouletteConstant) survivalProbability = survival();
    }
    bool survives = toUnit(random.w) < MUTATE(RouletteCapped, survivalProbability, min(survivalProbability, 0.5));
    goesOn = goesOn && maxComponent(beta) > 0.0 && survives;
    path.beta = beta / MUTATE(SurvivalNotDivided, survivalProbability, 1.0);
    if (kEffectBounceLimit && path.bounce >= bounceLimit && !(path.emit || kEffectBackground)) goesOn = false;
    if (kEffectPathKinds && historyDead(path.history)) goesOn = false;
    if (goesOn && path.bounce >= kBounceCap) {
      reportCappedPath();
      goesOn = false;
    }
  }
  if (kEffectSplitting && !goesOn && path.waiting > 0u) {
    resumeBranch(path);
    goesOn = true;
  }
  return goesOn;
}

// Extends the path by one vertex. Returns whether it goes on.
bool Li(INOUT(Path) path) {
  Hit hit = traceClosest(path.ray);
  DirectLight direct;
  bool goesOn = extendPath(path, hit, direct);
  bool waits = kEffectLightSampling && !kEffectLightSamples;
  bool occluded = waits && traceOccluded(direct.shadow, direct.end, direct.target);
  gatherDirect(path, direct, occluded);
  return goesOn;
}
