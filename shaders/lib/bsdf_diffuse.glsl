// Lambertian reflection: f = albedo / pi; sampled in proportion to the cosine.

Vec3 diffuseF(Material m) { return m.reflectance * MUTATE(InversePiDropped, kInvPi, 1.0); }

BsdfSample sampleDiffuse(Material m, Vec3 n, Vec3 ng, Vec2 u) {
  BsdfSample s;
  s.wi = normalize(toWorld(makeFrame(n), squareToCosineHemisphere(u)));
  s.weight = dot(s.wi, ng) > 0.0 ? m.reflectance : Vec3(0.0); // an opaque surface: nothing goes through it
  s.specular = false;
  return s;
}
