// Smooth glass: Fresnel reflection or refraction, chosen in proportion to their shares. Radiance is not scaled
// by the square of the index: the scale cancels for every path that leaves the glass again.

// Unpolarised reflectance at cosI in [0, 1]; eta: index on the other side over the index on this side. OUT cosT:
// cosine on the other side, 0 under total internal reflection. Exactly 0 for eta = 1, at grazing incidence too.
Float fresnelDielectric(Float cosI, Float eta, OUT(Float) cosT) {
  Float sin2T = (1.0 - cosI * cosI) / (eta * eta);
  cosT = sqrt(max(1.0 - sin2T, 0.0));
  Float rs = (cosI - eta * cosT) / (cosI + eta * cosT);
  Float rp = (eta * cosI - cosT) / (eta * cosI + cosT);
  Float f = sin2T >= 1.0 ? 1.0 : MUTATE(FresnelOnePolarisation, 0.5 * (rs * rs + rp * rp), rs * rs);
  return eta == 1.0 ? 0.0 : f;
}

struct DielectricDirection {
  Vec3 wi;
  bool reflected;
  bool total; // reflected totally
};

// A direction by Snell's law about n; `u` in [0, 1) chooses the branch.
DielectricDirection dielectricDirection(Vec3 wo, Vec3 n, Float eta, Float u) {
  Float cosI = min(dot(n, wo), 1.0);
  Float cosT;
  Float f = fresnelDielectric(cosI, eta, cosT);
  DielectricDirection d;
  d.reflected = MUTATE(AlwaysReflects, u < MUTATE(NeverReflects, f, floor(f)), true);
  d.total = cosT == 0.0;
  Vec3 reflection = n * (2.0 * cosI) - wo;
  Vec3 refraction = n * (cosI / eta - cosT) - wo / eta;
  d.wi = d.reflected ? reflection : refraction;
  return d;
}

// front: the ray comes from the side the normal points to, the index `m.ior` lies behind.
BsdfSample sampleDielectric(Material m, Vec3 wo, Vec3 n, Vec3 ng, bool front, Float u) {
  bool entering = MUTATE(GlassAlwaysEntered, front, true);
  Float eta = MUTATE(EtaInverted, entering, !entering) ? m.ior : 1.0 / m.ior;
  BsdfSample s;
  DielectricDirection d = dielectricDirection(wo, n, eta, u);
  s.wi = d.wi;
  if (kEffectSmoothNormals) {
    // The geometric normal decides where the shading normal sends light to the wrong side, and where only the
    // shading normal reflects totally: a smooth sphere lets out what it let in, its facets must not trap it.
    DielectricDirection g = dielectricDirection(wo, ng, eta, u);
    bool wrongSide = (dot(d.wi, ng) > 0.0) != d.reflected;
    if (wrongSide || (d.total && !g.total)) s.wi = g.wi;
  }
  s.wi = normalize(s.wi);
  s.weight = Vec3(1.0);
  s.specular = true;
  return s;
}
