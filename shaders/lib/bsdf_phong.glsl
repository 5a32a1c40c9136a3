// Phong's model as Nori's course has it: f = kd / pi + ks (n + 2) / (2 pi) cos^n(alpha), alpha between wi and the
// mirror direction of wo; sampled by a mixture of the two lobes. Energy is not conserved for kd + ks > 1.

// log(1 - x) for x in [0, 1]; the logarithm would lose what makes a narrow lobe.
Float logOneMinus(Float x) {
  Float series = -x * (1.0 + x * (0.5 + x * (1.0 / 3.0 + x * (0.25 + x * 0.2))));
  return x < 0.015625 ? series : log(1.0 - x);
}
// 1 - exp(x) for x <= 0.
Float oneMinusExp(Float x) {
  Float series = -x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0))));
  return x > -0.015625 ? series : 1.0 - exp(x);
}

Float luminance(Vec3 c) { return dot(c, Vec3(0.212671, 0.715160, 0.072169)); }
Float phongSpecularShare(Material m) {
  Float specular = luminance(m.specular);
  Float total = specular + luminance(m.reflectance);
  return total > 0.0 ? specular / total : 0.0;
}

// The weight of both lobes towards wi, which lies above the surface.
BsdfValue evaluatePhong(Material m, Vec3 wo, Vec3 wi, Vec3 n) {
  Vec3 mirrored = n * (2.0 * dot(n, wo)) - wo;
  Vec3 difference = wi - mirrored;
  Float versine = min(0.5 * dot(difference, difference), 1.0); // 1 - cos(alpha), without its cancellation
  Float power = m.roughness > 0.0 ? MUTATE(PhongByPower, exp(m.roughness * logOneMinus(versine)),
                                           pow(max(dot(wi, mirrored), 0.0), m.roughness))
                                  : 1.0;
  Float lobe = versine < 1.0 ? power * (0.5 * kInvPi) : 0.0;
  Float share = phongSpecularShare(m);
  BsdfValue value;
  value.f = m.reflectance * kInvPi + m.specular * ((m.roughness + 2.0) * lobe);
  value.pdf_w = (1.0 - share) * dot(n, wi) * kInvPi +
                share * MUTATE(PhongNormalisation, m.roughness + 1.0, m.roughness + 2.0) * lobe;
  return value;
}

// A direction from one of the lobes, `u.z` chooses; it may lie below the surface.
Vec3 samplePhongDirection(Material m, Vec3 wo, Vec3 n, Vec3 u) {
  Vec3 mirrored = n * (2.0 * dot(n, wo)) - wo;
  bool specular = u.z < phongSpecularShare(m);
  // cos(alpha) = (1 - u)^(1 / (n + 1)), by its logarithm.
  Float logCos = MUTATE(PhongLogCancels, logOneMinus(u.x), log(1.0 - u.x)) / (m.roughness + 1.0);
  Float sinAlpha = sqrt(MUTATE(PhongSineCancels, oneMinusExp(2.0 * logCos), 1.0 - exp(logCos) * exp(logCos)));
  Float phi = 2.0 * kPi * u.y;
  Vec3 lobe = Vec3(sinAlpha * cos(phi), sinAlpha * sin(phi), exp(logCos));
  Vec3 local = specular ? lobe : squareToCosineHemisphere(Vec2(u.x, u.y));
  return normalize(toWorld(makeFrame(normalize(specular ? mirrored : n)), local));
}
