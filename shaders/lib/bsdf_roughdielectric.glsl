// Rough glass: microfacets of smooth glass, which reflect or refract by Fresnel's share. Walter et al. 2007, eq. 20
// and 21, with masking correlated by height for both. As in smooth glass, radiance is not scaled by the square of the
// index: the BSDF of transmission from one side is that from the other times the square of their index, and neither
// makes energy. Light that hits a second facet is lost.
// Where the shading normal and the triangle disagree on the side of a direction, nothing goes there.

// Index behind the surface, as seen from wo, over the index on wo's side.
Float indexBeyond(Material m, bool front) {
  return MUTATE(RoughGlassAlwaysEntered, front, true) ? m.ior : 1.0 / m.ior;
}

// 2 (wo . h) dh/dwi of refraction, from the cosines on both sides: Walter et al., eq. 17. 0 where one of them is, as
// no refraction leads there.
Float refractionSpread(Float cosO, Float cosT, Float eta) {
  Float across = cosO - eta * cosT;
  Float spread = 2.0 * cosO * cosT * MUTATE(RefractionJacobianWrong, eta * eta, 1.0) / (across * across);
  return cosO > 0.0 && cosT > 0.0 ? spread : 0.0;
}

// 1 - fresnelDielectric(), without its cancellation near total reflection.
Float fresnelTransmittance(Float cosO, Float cosT, Float eta) {
  Float s = cosO + eta * cosT;
  Float p = eta * cosO + cosT;
  return cosT > 0.0 ? 2.0 * eta * cosO * cosT * (1.0 / (s * s) + 1.0 / (p * p)) : 0.0;
}

BsdfValue evaluateRoughDielectric(Surface s, Vec3 wo, Vec3 wi) {
  Float eta = indexBeyond(s.m, s.front);
  bool reflected = dot(s.n, wi) > 0.0;
  Vec3 h = normalize(wo + wi * (reflected ? 1.0 : eta));
  h = dot(s.n, h) < 0.0 ? -h : h;
  Float cosO = clamp(dot(wo, h), 0.0, 1.0);
  Float cosT = max(-dot(wi, h), 0.0);
  Float unused;
  Float share = fresnelDielectric(cosO, eta, unused);
  Float refraction = fresnelTransmittance(cosO, cosT, eta) * refractionSpread(cosO, cosT, eta);
  Float spread = reflected ? share * kReflectionSpread : refraction;
  FacetValue facets = facetValue(s.m.roughness, isBeckmann(s.m), wo, wi, s.n, h, spread);
  BsdfValue value;
  value.f = Vec3(facets.f);
  value.pdf_w = facets.pdf_w;
  return value;
}

// `u.z` chooses between reflection and refraction; a direction may lie on the wrong side: its weight is 0.
BsdfSample sampleRoughDielectric(Surface s, Vec3 wo, Vec3 u) {
  Float eta = indexBeyond(s.m, s.front);
  Facet facet = sampleFacet(s.m.roughness, isBeckmann(s.m), wo, s.n, Vec2(u.x, u.y));
  Float cosT;
  Float share = fresnelDielectric(facet.cosH, eta, cosT);
  bool reflected = u.z < share;
  Vec3 wi = reflected ? facet.h * (2.0 * facet.cosH) - facet.wo
                      : facet.h * (facet.cosH / eta - cosT) - facet.wo / eta;
  Float refraction = fresnelTransmittance(facet.cosH, cosT, eta) * refractionSpread(facet.cosH, cosT, eta);
  Float spread = reflected ? share * kReflectionSpread : refraction;
  BsdfSample b = facetSample(facet, s.m.roughness, isBeckmann(s.m), wi, spread);
  b.weight = (wi.z > 0.0) == reflected ? b.weight : Vec3(0.0);
  return b;
}
