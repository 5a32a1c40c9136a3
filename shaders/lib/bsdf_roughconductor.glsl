// Rough metal: microfacets of a smooth conductor. Walter et al. 2007, eq. 20, with Fresnel's equations for a complex
// index. Light that hits a second facet is lost, more of it the rougher the metal.

BsdfValue evaluateRoughConductor(Material m, Vec3 wo, Vec3 wi, Vec3 n) {
  Vec3 h = normalize(wo + wi);
  FacetValue facets = facetValue(m.roughness, isBeckmann(m), wo, wi, n, h,
                                 MUTATE(ReflectionJacobianDropped, kReflectionSpread, 2.0 * dot(wo, h)));
  BsdfValue value;
  value.f = conductorReflectance(m, clamp(dot(wo, h), 0.0, 1.0)) * facets.f;
  value.pdf_w = facets.pdf_w;
  return value;
}

// May lie below the surface.
BsdfSample sampleRoughConductor(Material m, Vec3 wo, Vec3 n, Vec2 u) {
  Facet facet = sampleFacet(m.roughness, isBeckmann(m), wo, n, u);
  Vec3 wi = facet.h * (2.0 * facet.cosH) - facet.wo;
  BsdfSample s = facetSample(facet, m.roughness, isBeckmann(m), wi, kReflectionSpread);
  s.weight = s.weight * conductorReflectance(m, facet.cosH);
  return s;
}
