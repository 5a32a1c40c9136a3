// Nori's `microfacet`: f = kd / pi + ks F D G / (4 zo zi), a diffuse base under a rough dielectric coat, with
// Beckmann's D and, as its course defines it, the rational fit of Smith's G1 for each direction (Walter et al. 2007,
// eq. 27 and the fit below it). Sampled by the cosine or by visible normals, in proportion to what the two reflect.

// G1 / z of the fit; finite at grazing incidence.
Float coatMasking(Float alpha, Float z) {
  Float spread = alpha * sqrt(max(1.0 - z * z, 0.0));
  Float b = z / max(spread, 0.5 * z); // 1 / (alpha tan), cut where G1 is 1 anyway
  Float fit = (3.535 + 2.181 * b) / (spread * (1.0 + 2.276 * b + 2.577 * b * b));
  return b < 1.6 ? fit : 1.0 / z;
}

// Probability of the coat's lobe: by its reflectance were it smooth, but a tenth at least, as facets turned away
// may reflect far more.
Float coatShare(Material m, Float zo) {
  Float unused;
  Float coat = meanComponent(m.specular) * fresnelDielectric(zo, m.ior, unused);
  Float base = luminance(m.reflectance);
  Float share = coat + base > 0.0 ? max(coat / (coat + base), 0.1) : 0.0;
  return maxComponent(m.specular) > 0.0 ? share : 0.0;
}

BsdfValue evaluateMicrofacet(Surface s, Vec3 wo, Vec3 wi) {
  Material m = s.m;
  Vec3 h = normalize(wo + wi);
  Float zo = clamp(dot(s.n, wo), 0.0, 1.0);
  Float zi = clamp(dot(s.n, wi), 0.0, 1.0);
  Float unused;
  Float fresnel = fresnelDielectric(clamp(dot(wo, h), 0.0, 1.0), m.ior, unused);
  Float density = facetDensity(m.roughness, true, facetAngle(s.n, h));
  Float coat = 0.25 * density * MUTATE(CoatFresnelDropped, fresnel, 1.0) * coatMasking(m.roughness, zo) *
               coatMasking(m.roughness, zi);
  Float share = coatShare(m, zo);
  BsdfValue value;
  value.f = m.reflectance * kInvPi + m.specular * coat;
  value.pdf_w = (1.0 - share) * zi * kInvPi +
                share * kReflectionSpread * density / smithTerm(m.roughness, true, zo);
  return value;
}

// `u.z` chooses the lobe; the direction may lie below the surface.
BsdfSample sampleMicrofacet(Surface s, Vec3 wo, Vec3 u) {
  Facet facet = sampleFacet(s.m.roughness, true, wo, s.n, Vec2(u.x, u.y));
  Vec3 mirrored = facet.h * (2.0 * facet.cosH) - facet.wo;
  bool coat = u.z < coatShare(s.m, min(facet.wo.z, 1.0));
  Vec3 wi = normalize(toWorld(facet.frame, coat ? mirrored : squareToCosineHemisphere(Vec2(u.x, u.y))));
  return smoothSample(s, wi, evaluateMicrofacet(s, wo, wi));
}
