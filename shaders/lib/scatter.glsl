// The choice between the BSDFs. A new one has a line in each of these functions, and a file.

// Whether light sampling can find what the surface scatters: it is not a delta distribution.
bool isSmooth(uint bsdf) {
  bool found = false;
  if (kEffectDiffuse) found = found || bsdf == kBsdfDiffuse;
  if (kEffectPhong) found = found || bsdf == kBsdfPhong;
  return found;
}

// For a smooth BSDF and wi on a side that it scatters to: f, and the density with which sampleBsdf() finds wi.
BsdfValue evaluateBsdf(Surface s, Vec3 wo, Vec3 wi) {
  BsdfValue value = evaluateDiffuse(s.m, wi, s.n);
  if (kEffectPhong && s.m.bsdf == kBsdfPhong) value = evaluatePhong(s.m, wo, wi, s.n);
  return value;
}

// Whether a smooth BSDF scatters to wi at all.
bool scattersTo(Surface s, Vec3 wi) { return dot(s.n, wi) > 0.0 && dot(s.ng, wi) > 0.0; }

// A sample of a lobe in direction wi, its weight from evaluateBsdf().
BsdfSample smoothSample(Surface s, Vec3 wo, Vec3 wi) {
  BsdfSample b;
  b.wi = wi;
  b.specular = false;
  BsdfValue value = evaluateBsdf(s, wo, wi);
  b.pdf_w = value.pdf_w;
  b.weight = scattersTo(s, wi) ? value.f * (abs(dot(s.n, wi)) / value.pdf_w) : Vec3(0.0);
  return b;
}

// A direction in proportion to what the surface scatters. Specular transmission is sampled by the caller from
// dielectricBranches() where both branches are followed.
BsdfSample sampleBsdf(Surface s, Vec3 wo, UVec4 random) {
  BsdfSample b = specularSample(s.ng, Vec3(0.0));
  if (kEffectDiffuse && s.m.bsdf == kBsdfDiffuse) {
    b = sampleDiffuse(s.m, s.n, s.ng, Vec2(toUnit(random.x), toUnit(random.y)));
  }
  if (kEffectMirror && s.m.bsdf == kBsdfMirror) b = sampleMirror(s.m, wo, s.n, s.ng);
  if (kEffectGlass && s.m.bsdf == kBsdfDielectric) {
    b = sampleDielectric(dielectricBranches(s.m, wo, s.n, s.ng, s.front), toUnit(random.z));
  }
  if (kEffectMetal && s.m.bsdf == kBsdfConductor) b = sampleConductor(s.m, wo, s.n, s.ng);
  if (kEffectPhong && s.m.bsdf == kBsdfPhong) {
    b = smoothSample(s, wo, samplePhongDirection(s.m, wo, s.n, Vec3(toUnit(random.x), toUnit(random.y), toUnit(random.z))));
  }
  return b;
}
