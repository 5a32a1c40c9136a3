// A BSDF that no scene has, for test_kernel_size.cpp: Lambert's, and a rim where surfaces are seen at grazing angles.

BsdfValue evaluateVelvet(Surface s, Vec3 wo, Vec3 wi) {
  BsdfValue value = evaluateDiffuse(s, wo, wi);
  Float rim = pow(1.0 - abs(dot(s.n, wo)), s.m.roughness) * pow(1.0 - abs(dot(s.n, wi)), s.m.roughness);
  value.f = value.f + s.m.specular * rim;
  return value;
}

BsdfSample sampleVelvet(Surface s, Vec3 wo, Vec3 u) {
  Vec3 wi = normalize(toWorld(makeFrame(s.n), squareToCosineHemisphere(Vec2(u.x, u.y))));
  return smoothSample(s, wi, evaluateVelvet(s, wo, wi));
}
