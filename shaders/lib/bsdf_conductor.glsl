// Smooth metal: mirror reflection weighted by Fresnel's equations for a complex index of refraction.

// Unpolarised reflectance at cosI in [0, 1] for eta + i k (one channel), outside index 1.
// Born and Wolf, Principles of Optics, 14.4; in the form a^2 + b^2, a of its complex square root.
Float fresnelConductor(Float cosI, Float eta, Float k) {
  Float cos2 = cosI * cosI;
  Float sin2 = 1.0 - cos2;
  Float k2 = MUTATE(ConductorAbsorptionDropped, k * k, 0.0);
  Float t0 = eta * eta - k2 - sin2;
  Float a2b2 = sqrt(t0 * t0 + 4.0 * eta * eta * k2);
  Float a = sqrt(max(0.5 * (a2b2 + t0), 0.0));
  Float rs = (a2b2 + cos2 - 2.0 * a * cosI) / (a2b2 + cos2 + 2.0 * a * cosI);
  Float t3 = cos2 * a2b2 + sin2 * sin2;
  Float t4 = 2.0 * a * cosI * sin2;
  Float rp = rs * (t3 - t4) / (t3 + t4);
  return 0.5 * (rs + rp);
}

Vec3 conductorReflectance(Material m, Float cosI) {
  return Vec3(fresnelConductor(cosI, m.eta.x, m.k.x), fresnelConductor(cosI, m.eta.y, m.k.y),
              fresnelConductor(cosI, m.eta.z, m.k.z));
}

BsdfSample sampleConductor(Surface s, Vec3 wo, Vec3) {
  return reflectedSample(s, wo, conductorReflectance(s.m, min(abs(dot(s.n, wo)), 1.0)));
}
