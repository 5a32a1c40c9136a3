// Perfect mirror of a constant reflectance.

BsdfSample sampleMirror(Material m, Vec3 wo, Vec3 n, Vec3 ng) {
  BsdfSample s;
  s.wi = reflectAbove(wo, n, ng);
  s.weight = m.reflectance;
  s.specular = true;
  return s;
}
