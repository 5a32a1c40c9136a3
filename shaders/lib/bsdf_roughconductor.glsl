// Rough metal: microfacets of a smooth conductor. Walter et al. 2007, eq. 20, with Fresnel's equations for a complex
// index. Light that hits a second facet is lost, more of it the rougher the metal.

BsdfValue evaluateRoughConductor(Surface s, Vec3 wo, Vec3 wi) {
  Material m = s.m;
  Vec3 h = normalize(wo + wi);
  FacetValue facets = facetValue(m.roughness, isBeckmann(m), wo, wi, s.n, h,
                                 MUTATE(ReflectionJacobianDropped, kReflectionSpread, 2.0 * dot(wo, h)));
  BsdfValue value;
  value.f = conductorReflectance(m, clamp(dot(wo, h), 0.0, 1.0)) * facets.f;
  value.pdf_w = facets.pdf_w;
  return value;
}

// May lie below the surface.
BsdfSample sampleRoughConductor(Surface s, Vec3 wo, Vec3 u) {
  Material m = s.m;
  Facet facet = sampleFacet(m.roughness, isBeckmann(m), wo, s.n, Vec2(u.x, u.y));
  Vec3 wi = facet.h * (2.0 * facet.cosH) - facet.wo;
  BsdfSample b = facetSample(facet, m.roughness, isBeckmann(m), wi, kReflectionSpread);
  b.weight = b.weight * conductorReflectance(m, facet.cosH);
  return b;
}
