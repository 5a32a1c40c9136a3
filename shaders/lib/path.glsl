// The estimator. Radiance in W m^-2 sr^-1; beta is the product of f cos / pdf over the path's vertices.

bool weighsStrategies() { return kEffectMis && lightStrategy() == kStrategyMis; }
// Whether light sampling finds the emitters that a ray can hit: delta lights alone are sampled in any case.
bool samplesEmitters() { return kEffectLightSampling && lightStrategy() != kStrategyBsdf; }

// Adds light that a path of this history has found.
void gather(INOUT(Path) path, uint history, Vec3 L) {
  Vec3 counted = L;
  if (kEffectPathKinds && !MUTATE(UnwantedKindsCount, kindWanted(history), true)) counted = Vec3(0.0);
  if (kEffectKindImages) recordKind(kindOf(history), counted * path.sampleWeight);
  path.L += counted;
}

// By way of the subgroup: a kernel with a loop whose bound is a uniform is compiled anew for every dispatch by lavapipe.
uint lightSampleCount() { return subgroupMaximum(lightSamples()); }

Vec3 treeNormal(Surface s) { return isRoughGlass(s.m.bsdf) ? Vec3(0.0) : s.n; }

// Density over area with which light sampling would have found the emitter that the path has hit.
Float lightPdf_A(Path path, Surface s) {
  Float pdf_A = s.m.lightPdf_A;
  if (choosesByTree()) {
    bool sampled = pdf_A > 0.0 && path.pdf_w > 0.0;
    Float probability = treeProbability(s.lightLeaf, sampled, path.from, path.fromNormal, path.fromTable);
    if (sampled) pdf_A = MUTATE(TreeWeighedByPower, probability * 2.0 / s.doubleArea, pdf_A);
  }
  return pdf_A;
}

// One light sample: radiance f cos Le / pdf_w.
DirectLight sampleDirect(Surface s, Vec3 wo, UVec4 random, UVec4 more, bool wanted) {
  LightSample light = sampleLight(s.p, treeNormal(s), random, more);
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
  d.pixel = kNoPixel;
  return d;
}

// Adds it to the path or to another pixel, now that its shadow ray has ended.
void gatherDirect(INOUT(Path) path, DirectLight d, bool occluded) {
  Vec3 L = MUTATE(OcclusionIgnored, occluded, false) ? Vec3(0.0) : d.L;
  if (!kFromLight) gather(path, d.history, L);
  if (kFromLight && d.pixel != kNoPixel && maxComponent(L) > 0.0) splat(d.pixel, path.pixel, L);
}

// Weight of emission that BSDF sampling has found, where light sampling would have found it with density pdf_w.
Float emissionWeight(Path path, Float lightPdf_w) {
  Float samples = Float(kEffectLightSamples ? MUTATE(MisSamplesIgnored, lightSamples(), 1u) : 1u);
  return weighsStrategies() && path.pdf_w > 0.0 && lightPdf_w > 0.0 ? misWeight(path.pdf_w, samples * lightPdf_w) : 1.0;
}

// The same where a path from a light would have found it.
Float causticWeight(Path path, Float lightPdf_A) {
  bool both = path.otherPdf_A > 0.0 && path.pdf_w == 0.0;
  return both ? MUTATE(CausticsTwice, misWeight(path.otherPdf_A, lightPdf_A), 1.0) : 1.0;
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

// Where a sample's several paths go on from the glass that they begin at: to each side go as many as its share of the light
// asks for, and one at least, each weighted by what it stands for. Left to chance, a lamp's reflection would be found by one
// path in 25. Proportional allocation over two strata: Cochran 1977, "Sampling Techniques", 5.
BsdfSample allottedBranch(Path path, Surface s, Vec3 wo, BsdfSample b) {
  DielectricBranches d = dielectricBranches(s.m, wo, s.n, s.ng, s.front);
  Float paths = Float(path.repeats);
  Float above = clamp(floor(paths * d.share + 0.5), 1.0, paths - 1.0); // that are reflected
  bool reflected = Float(path.repeat) < above;
  Float share = reflected ? d.share : 1.0 - d.share;
  BsdfSample a = b;
  if (d.share > 0.0 && d.share < 1.0) {
    a.wi = normalize(reflected ? d.reflection : d.refraction);
    a.weight = Vec3(MUTATE(AllottedUnweighted, share * paths / (reflected ? above : paths - above), 1.0));
  }
  return a;
}

// Light that a path meets as it leaves the scene.
void gatherBackground(INOUT(Path) path) {
  if (kEffectBackground) {
    gather(path, path.history, path.beta * MUTATE(BackgroundTwice, background(), 2.0 * background()));
  }
  if (kEffectEnvironment && path.emit) {
    EnvironmentRecord e = environmentAt(path.ray.d);
    Float probability = environmentProbability();
    if (choosesByTree()) probability = treeProbability(environmentLeaf(), true, path.from, path.fromNormal, path.fromTable);
    gather(path, path.history, path.beta * e.radiance * emissionWeight(path, e.pdf_w * probability));
  }
}

// Extends the path by the vertex that its ray has hit. Returns whether it goes on; what the lights send by way of the
// vertex is `direct`, still to be gathered.
bool extendPath(INOUT(Path) path, Hit hit, OUT(DirectLight) direct) {
  direct = noDirectLight();
  Vec3 wo = -path.ray.d;
  bool goesOn = hit.triangle != kNoTriangle;
  if (!goesOn) {
    if (!kFromLight) gatherBackground(path);
  } else {
    Surface s = surfaceAt(hit, wo);
    if (kEffectAbsorption && !s.front && isGlass(s.m.bsdf)) {
      path.beta = path.beta * exp(-s.m.absorption * hit.t); // the way here lay behind the surface
    }

    // SEVERAL PATHS for a sample that begins at a specular surface: what it leads to is as bright as it is rare.
    if (kEffectSpecularSamples && !kFromLight && path.bounce == 0u && path.repeat == 0u && isSpecular(s.m.bsdf)) {
      path.repeats = specularSamples();
      path.sampleWeight = path.sampleWeight * MUTATE(RepeatsNotAveraged, 1.0 / Float(path.repeats), 1.0);
    }

    // EMISSION: L += beta Le, unless the vertex before has sampled the emitters itself.
    if (kEffectAreaLights && path.emit && MUTATE(BackEmits, s.front, true)) {
      Float weight = emissionWeight(path, areaToSolidAngle(lightPdf_A(path, s), hit.t * hit.t, dot(s.ng, wo)));
      if (kEffectLightTracing) weight *= causticWeight(path, s.m.lightPdf_A);
      gather(path, path.history, MUTATE(ThroughputDropped, path.beta, Vec3(1.0)) * s.m.emission * weight);
    }
    uint bounceLimit = MUTATE(BounceLimitOffByOne, maxBounces(), maxBounces() + 1u);
    if (kEffectBounceLimit && path.bounce >= bounceLimit) goesOn = false;
    if (kEffectOneSided && !MUTATE(BackScatters, scattersHere(s), true)) goesOn = false;

    if (kEffectLightTracing && !kFromLight && path.bounce == 0u && isSmooth(s.m.bsdf)) {
      Float pdf_A = eyePdf_A(hit.t * hit.t, abs(dot(s.ng, wo)), dot(path.ray.d, cameraForward()));
      path.otherPdf_A = tracesLights() ? pdf_A : 0.0;
    }

    // REUSE: what this vertex sends on counts for the neighbours, too.
    if (reusesPaths() && leavesVertices() && path.bounce == 1u) {
      if (kEffectLightTracing && path.otherPdf_A > 0.0 && isSmooth(s.m.bsdf)) path.otherPdf_A = sharedEyePdf_A();
      bool isShared = path.reuse == kReuseFirst && goesOn && reusableFrom(s);
      if (path.reuse == kReuseFirst) path.reuse = kReuseAlone;
      if (isShared) leaveSecondVertex(path, s, hit.triangle);
    }

    // DIRECT: next event estimation at surfaces that are not specular.
    if (kEffectLightSampling && goesOn && !kFromLight) {
      uint history = afterDiffuse(path.history);
      bool wanted = !kEffectPathKinds || kindWanted(history);
      uint count = kEffectLightSamples ? lightSampleCount() : 1u;
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

    if (kFromLight && goesOn) direct = connectToEye(path, s, wo);

    // INDIRECT: one direction from the BSDF; the emission it finds counts as far as no light sample found it.
    UVec4 random = pathRandom(path, blockBsdf(path.bounce));
    BsdfSample b = sampleBsdf(s, wo, random);
    bool guided = isGuided(path) && s.m.bsdf == kBsdfDiffuse;
    if (guided) b = guidedSample(s, wo, random, b);
    bool allotted = kEffectSpecularSamples && path.repeats > 1u && path.bounce == 0u && s.m.bsdf == kBsdfDielectric;
    if (kEffectGlass && allotted) b = allottedBranch(path, s, wo, b);
    bool specular = b.specular;
    Float total = b.weight.x + b.weight.y + b.weight.z;
    if (!isFinite(total) || (!specular && total > 0.0 && !(b.pdf_w > 0.0 && isFinite(b.pdf_w)))) {
      reportInvalidPdf();
      b.weight = Vec3(0.0);
    }
    if (kFromLight) b.weight = adjointWeight(s, wo, b);
    if (kEffectLightTracing && !kFromLight && !b.reversible) path.otherPdf_A = 0.0;
    Vec3 beta = path.beta * b.weight;
    path.emit = MUTATE(EmissionTwice, specular || !samplesEmitters() || weighsStrategies(), true) && !kFromLight;
    path.pdf_w = specular ? 0.0 : b.pdf_w;
    path.from = s.p;
    path.fromNormal = treeNormal(s);
    if (choosesByTree() && kByLightTables) path.fromTable = lightTableAt(path.from, path.fromNormal);
    uint history = specular ? afterSpecular(path.history, dot(b.wi, s.ng) < 0.0) : afterDiffuse(path.history);
    if (kFromLight) {
      goesOn = goesOn && (specular || path.bounce > 0u); // what comes straight from a light is light sampling's
      history = specular ? lightAfterSpecular(path.history, dot(b.wi, s.ng) < 0.0) : kLightScattered;
    }
    bool shares = reusesPaths() && leavesVertices() && goesOn && path.bounce == 0u && reusable(s);
    bool spared = isGuided(path) && specular && behindDiffuse(path.history); // from roulette
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
      // As if the BSDF had chosen the direction: where the guide has, more paths bring less each, which is what it is for.
      Vec3 weight = guided ? s.m.reflectance : (allotted ? Vec3(1.0) : b.weight);
      Vec3 throughput = guided ? path.beta * s.m.reflectance : beta;
      survivalProbability = min(1.0, kRouletteMode == kRouletteAlbedo ? meanComponent(weight) : maxComponent(throughput));
      if (kRouletteMode == kRouletteConstant) survivalProbability = survival();
      if (kFromLight) survivalProbability = min(1.0, maxComponent(b.weight));
    }
    if (shares) leaveFirstVertex(path, s, survivalProbability);
    bool survives = toUnit(random.w) < MUTATE(RouletteCapped, survivalProbability, min(survivalProbability, 0.5));
    goesOn = goesOn && MUTATE(BlackGoesOn, maxComponent(beta) > 0.0 && survives, maxComponent(beta) == 0.0 || survives);
    path.beta = beta / MUTATE(SurvivalNotDivided, survivalProbability, 1.0);
    bool last = kEffectBounceLimit && path.bounce >= bounceLimit;
    if (last && (kFromLight || !(path.emit || kEffectBackground))) goesOn = false;
    if (kEffectPathKinds && !kFromLight && historyDead(path.history)) goesOn = false;
    if (goesOn && path.bounce >= MUTATE(DepthCapped, kBounceCap, 64u)) {
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
  bool waits = (kEffectLightSampling && !kEffectLightSamples) || kEffectLightTracing;
  bool occluded = waits && traceOccluded(direct.shadow, direct.end, direct.target);
  gatherDirect(path, direct, occluded);
  return goesOn;
}
