// Perfect mirror of a constant reflectance.

BsdfSample sampleMirror(Surface s, Vec3 wo, Vec3) {
  return reflectedSample(s, wo, MUTATE(MirrorWeightDropped, s.m.reflectance, Vec3(1.0)));
}
