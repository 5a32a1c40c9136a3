// Perfect mirror of a constant reflectance.

BsdfSample sampleMirror(Surface s, Vec3 wo, Vec3) {
  return specularSample(reflectAbove(wo, s.n, s.ng), MUTATE(MirrorWeightDropped, s.m.reflectance, Vec3(1.0)));
}
