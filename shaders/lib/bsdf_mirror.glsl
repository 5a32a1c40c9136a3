// Perfect mirror of a constant reflectance.

BsdfSample sampleMirror(Material m, Vec3 wo, Vec3 n, Vec3 ng) {
  return specularSample(reflectAbove(wo, n, ng), MUTATE(MirrorWeightDropped, m.reflectance, Vec3(1.0)));
}
