// Lambertian reflection: f = albedo / pi; sampled in proportion to the cosine.

BsdfValue evaluateDiffuse(Surface s, Vec3, Vec3 wi) {
  BsdfValue value;
  value.f = s.m.reflectance * MUTATE(InversePiDropped, kInvPi, 1.0);
  value.pdf_w = dot(s.n, wi) * kInvPi;
  return value;
}

BsdfSample sampleDiffuse(Surface s, Vec3, Vec3 u) {
  Vec3 local = squareToCosineHemisphere(Vec2(u.x, u.y));
  BsdfSample b;
  b.wi = normalize(toWorld(makeFrame(s.n), local));
  b.weight = MUTATE(AlbedoClamped, s.m.reflectance, min(s.m.reflectance, Vec3(1.0)));
  b.pdf_w = local.z * kInvPi;
  b.specular = false;
  b.reversible = true;
  return b;
}
