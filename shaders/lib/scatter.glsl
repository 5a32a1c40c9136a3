// The choice between the BSDFs. A new one has a line in each of these functions, and a file.

// Whether light sampling can find what the surface scatters: it is not a delta distribution.
bool isSmooth(uint bsdf) {
  bool found = false;
  if (kEffectDiffuse) found = found || bsdf == kBsdfDiffuse;
  if (kEffectPhong) found = found || bsdf == kBsdfPhong;
  if (kEffectMicrofacet) found = found || bsdf == kBsdfMicrofacet;
  if (kEffectRoughMetal) found = found || bsdf == kBsdfRoughConductor;
  if (kEffectRoughGlass) found = found || bsdf == kBsdfRoughDielectric;
  return found;
}

// Whether light goes through it to a medium that may absorb.
bool isGlass(uint bsdf) { return bsdf == kBsdfDielectric || (kEffectRoughGlass && bsdf == kBsdfRoughDielectric); }

// For a smooth BSDF and wi on a side that it scatters to: f, and the density with which sampleBsdf() finds wi.
BsdfValue evaluateBsdf(Surface s, Vec3 wo, Vec3 wi) {
  BsdfValue value = evaluateDiffuse(s.m, wi, s.n);
  if (kEffectPhong && s.m.bsdf == kBsdfPhong) value = evaluatePhong(s.m, wo, wi, s.n);
  if (kEffectMicrofacet && s.m.bsdf == kBsdfMicrofacet) value = evaluateMicrofacet(s.m, wo, wi, s.n);
  if (kEffectRoughMetal && s.m.bsdf == kBsdfRoughConductor) value = evaluateRoughConductor(s.m, wo, wi, s.n);
  if (kEffectRoughGlass && s.m.bsdf == kBsdfRoughDielectric) value = evaluateRoughDielectric(s.m, wo, wi, s.n, s.front);
  return value;
}

// Whether a smooth BSDF scatters to wi at all: the shading normal and the triangle agree on a side that it reaches.
bool scattersTo(Surface s, Vec3 wi) {
  Float shading = dot(s.n, wi);
  Float geometric = dot(s.ng, wi);
  bool found = shading > 0.0 && geometric > 0.0;
  if (kEffectRoughGlass) found = found || (s.m.bsdf == kBsdfRoughDielectric && shading < 0.0 && geometric < 0.0);
  return found;
}

// A sample that weighs nothing where the surface doesn't scatter.
BsdfSample scattered(Surface s, BsdfSample b) {
  b.weight = scattersTo(s, b.wi) ? b.weight : Vec3(0.0);
  return b;
}

// A sample of a lobe in direction wi, its weight from evaluateBsdf(). Where the density rounds to 0 so does f.
BsdfSample smoothSample(Surface s, Vec3 wo, Vec3 wi) {
  BsdfSample b;
  b.wi = wi;
  b.specular = false;
  BsdfValue value = evaluateBsdf(s, wo, wi);
  b.pdf_w = value.pdf_w;
  b.weight = value.pdf_w > 0.0 ? value.f * (abs(dot(s.n, wi)) / value.pdf_w) : Vec3(0.0);
  return scattered(s, b);
}

// A direction in proportion to what the surface scatters. Specular transmission is sampled by the caller from
// dielectricBranches() where both branches are followed.
BsdfSample sampleBsdf(Surface s, Vec3 wo, UVec4 random) {
  BsdfSample b = specularSample(s.ng, Vec3(0.0));
  Vec3 u = Vec3(toUnit(random.x), toUnit(random.y), toUnit(random.z));
  if (kEffectDiffuse && s.m.bsdf == kBsdfDiffuse) b = sampleDiffuse(s.m, s.n, s.ng, Vec2(u.x, u.y));
  if (kEffectMirror && s.m.bsdf == kBsdfMirror) b = sampleMirror(s.m, wo, s.n, s.ng);
  if (kEffectGlass && s.m.bsdf == kBsdfDielectric) {
    b = sampleDielectric(dielectricBranches(s.m, wo, s.n, s.ng, s.front), u.z);
  }
  if (kEffectMetal && s.m.bsdf == kBsdfConductor) b = sampleConductor(s.m, wo, s.n, s.ng);
  if (kEffectPhong && s.m.bsdf == kBsdfPhong) b = smoothSample(s, wo, samplePhongDirection(s.m, wo, s.n, u));
  if (kEffectMicrofacet && s.m.bsdf == kBsdfMicrofacet) {
    b = smoothSample(s, wo, sampleMicrofacetDirection(s.m, wo, s.n, u));
  }
  if (kEffectRoughMetal && s.m.bsdf == kBsdfRoughConductor) {
    b = scattered(s, sampleRoughConductor(s.m, wo, s.n, Vec2(u.x, u.y)));
  }
  if (kEffectRoughGlass && s.m.bsdf == kBsdfRoughDielectric) {
    b = scattered(s, sampleRoughDielectric(s.m, wo, s.n, s.front, u));
  }
  return b;
}
