// Lambertian reflection: f = albedo / pi; sampled in proportion to the cosine.

BsdfValue evaluateDiffuse(Material m, Vec3 wi, Vec3 n) {
  BsdfValue value;
  value.f = m.reflectance * MUTATE(InversePiDropped, kInvPi, 1.0);
  value.pdf_w = dot(n, wi) * kInvPi;
  return value;
}

BsdfSample sampleDiffuse(Material m, Vec3 n, Vec3 ng, Vec2 u) {
  Vec3 local = squareToCosineHemisphere(u);
  BsdfSample s;
  s.wi = normalize(toWorld(makeFrame(n), local));
  Vec3 albedo = MUTATE(AlbedoClamped, m.reflectance, min(m.reflectance, Vec3(1.0)));
  s.weight = dot(s.wi, ng) > 0.0 ? albedo : Vec3(0.0); // an opaque surface: nothing goes through it
  s.pdf_w = local.z * kInvPi;
  s.specular = false;
  return s;
}
