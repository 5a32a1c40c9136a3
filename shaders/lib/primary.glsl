// Views of what a camera ray meets, in place of the estimator: Li() for a viewer.

// What a surface is seen as under white light from all around, as far as one event tells: the albedo, the reflectance
// of a mirror, a metal's at normal incidence, white for glass; a lamp in its own colour.
Vec3 baseColour(Surface s) {
  Vec3 colour = s.m.reflectance;
  if (s.m.bsdf == kBsdfPhong || s.m.bsdf == kBsdfMicrofacet) colour += s.m.specular;
  if (s.m.bsdf == kBsdfDielectric || s.m.bsdf == kBsdfRoughDielectric) colour = Vec3(1.0);
  if (s.m.bsdf == kBsdfConductor || s.m.bsdf == kBsdfRoughConductor) colour = conductorReflectance(s.m, 1.0);
  Float emitted = maxComponent(s.m.emission);
  return emitted > 0.0 && s.front ? s.m.emission / emitted : colour;
}

// The whole path at once: it never goes on.
bool viewPrimary(INOUT(Path) path) {
  Hit hit = traceClosest(path.ray);
  if (hit.triangle != kNoTriangle) {
    Surface s = surfaceAt(hit, -path.ray.d);
    path.L = kPrimaryView == kPrimaryNormals ? (s.n + Vec3(1.0)) * 0.5 : baseColour(s);
  }
  return false;
}
