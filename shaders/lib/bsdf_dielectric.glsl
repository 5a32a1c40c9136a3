// Smooth glass: Fresnel reflection or refraction, chosen in proportion to their shares. Radiance is not scaled
// by the square of the index: the scale cancels for every path that leaves the glass again.

// Unpolarised reflectance at cosI in [0, 1]; eta: index on the other side over the index on this side. OUT cosT:
// cosine on the other side, 0 under total internal reflection. Exactly 0 for eta = 1, at grazing incidence too.
Float fresnelDielectric(Float cosI, Float eta, OUT(Float) cosT) {
  // (eta cosT)^2, grouped so that nothing cancels at grazing incidence on an index close to 1, nor head-on below a
  // large one.
  Float fromSine = eta * eta - (1.0 - cosI * cosI);
  Float fromCosine = cosI * cosI + (eta - 1.0) * (eta + 1.0);
  Float square = MUTATE(RefractionCancels, eta > 0.5, false) ? fromCosine : fromSine;
  cosT = sqrt(MUTATE(RefractionUnclamped, max(square, 0.0), square)) / eta;
  Float rs = (cosI - eta * cosT) / (cosI + eta * cosT);
  Float rp = (eta * cosI - cosT) / (eta * cosI + cosT);
  Float f = square <= 0.0 ? 1.0 : MUTATE(FresnelOnePolarisation, 0.5 * (rs * rs + rp * rp), rs * rs);
  return MUTATE(EqualIndicesUnguarded, eta == 1.0, false) ? 0.0 : f;
}

// The two ways from a smooth boundary.
struct DielectricBranches {
  Float share; // of light that is reflected
  Vec3 reflection;
  Vec3 refraction; // of no meaning where share is 1
  bool total;      // reflected totally
  bool reflectionReversible; // the same rule leads back
  bool refractionReversible;
};

// By Snell's law about n, on wo's side.
DielectricBranches dielectricAbout(Vec3 wo, Vec3 n, Float eta) {
  Float cosI = min(dot(n, wo), 1.0);
  Float cosT;
  DielectricBranches b;
  b.share = fresnelDielectric(cosI, eta, cosT);
  b.share = MUTATE(AlwaysReflects, MUTATE(NeverReflects, b.share, floor(b.share)), 1.0);
  b.total = cosT == 0.0;
  b.reflectionReversible = true;
  b.refractionReversible = true;
  b.reflection = n * (2.0 * cosI) - wo;
  b.refraction = n * (cosI / eta - cosT) - wo / eta;
  return b;
}

// front: the ray comes from the side the normal points to, the index `m.ior` lies behind.
DielectricBranches dielectricBranches(Material m, Vec3 wo, Vec3 n, Vec3 ng, bool front) {
  bool entering = MUTATE(GlassAlwaysEntered, front, true);
  Float eta = MUTATE(EtaInverted, entering, !entering) ? m.ior : 1.0 / m.ior;
  DielectricBranches b = dielectricAbout(wo, n, eta);
  if (kEffectSmoothNormals) {
    // The geometric normal decides where the shading normal sends light to the wrong side, and where only the
    // shading normal reflects totally: a smooth sphere lets out what it let in, its facets must not trap it.
    DielectricBranches g = dielectricAbout(wo, ng, eta);
    // By the shading normal alone; a total reflection by the geometric one too, on the way back as well.
    bool reflection = dot(b.reflection, ng) > 0.0 &&
                      (!b.total || (g.total && dielectricAbout(b.reflection, ng, eta).total));
    bool refraction = !b.total && dot(b.refraction, ng) < 0.0;
    if (b.total && !g.total) b = g;
    b.reflectionReversible = reflection;
    b.refractionReversible = refraction;
    if (dot(b.reflection, ng) <= 0.0) b.reflection = g.reflection;
    if (!b.total && dot(b.refraction, ng) >= 0.0) {
      if (g.total) b.refraction = g.reflection;
      else b.refraction = g.refraction;
    }
  }
  return b;
}

BsdfSample sampleDielectric(Surface s, Vec3 wo, Vec3 u) {
  DielectricBranches b = dielectricBranches(s.m, wo, s.n, s.ng, s.front);
  bool reflected = u.z < b.share;
  Vec3 weight = Vec3(MUTATE(RefractionScaled, 1.0, reflected ? 1.0 : 0.44));
  BsdfSample sampled = specularSample(normalize(reflected ? b.reflection : b.refraction), weight);
  sampled.reversible = dot(s.ns, wo) > 0.0 && (reflected ? b.reflectionReversible : b.refractionReversible);
  return sampled;
}
