// Perfect mirror of a constant reflectance.

BsdfSample sampleMirror(Material m, Vec3 wo, Vec3 n, Vec3 ng) {
  BsdfSample s;
  s.wi = reflectAbove(wo, n, ng);
  s.weight = MUTATE(MirrorWeightDropped, m.reflectance, Vec3(1.0));
  s.specular = true;
  return s;
}
