// The choice between the BSDFs of shared/effects.h. Each has, in a file of its own,
//   BsdfSample sampleTYPE(Surface s, Vec3 wo, Vec3 u)   a direction in proportion to what the surface scatters; u.z
//                                                       chooses between lobes. A smooth one may lie below the surface.
//   BsdfValue evaluateTYPE(Surface s, Vec3 wo, Vec3 wi) unless it is specular: f, and the density with which
//                                                       sampling finds wi, on a side that it scatters to.

// Whether light sampling can find what the surface scatters: it is not a delta distribution.
bool isSmooth(uint bsdf) {
  bool found = false;
#define VKPT_IS(Name, Type) if (kEffect##Name) found = found || bsdf == kBsdf##Type;
  VKPT_SMOOTH_BSDFS(VKPT_IS)
#undef VKPT_IS
  return found;
}

bool isSpecular(uint bsdf) {
  bool found = false;
#define VKPT_IS(Name, Type) if (kEffect##Name) found = found || bsdf == kBsdf##Type;
  VKPT_SPECULAR_BSDFS(VKPT_IS)
#undef VKPT_IS
  return found;
}

bool isRoughGlass(uint bsdf) { return kEffectRoughGlass && bsdf == kBsdfRoughDielectric; }
// Whether light goes through it to a medium that may absorb.
bool isGlass(uint bsdf) { return bsdf == kBsdfDielectric || isRoughGlass(bsdf); }

// Of a smooth BSDF, for a wi that scattersTo() is true of.
BsdfValue evaluateBsdf(Surface s, Vec3 wo, Vec3 wi) {
  BsdfValue value = evaluateDiffuse(s, wo, wi);
#define VKPT_EVALUATE(Name, Type) if (kEffect##Name && s.m.bsdf == kBsdf##Type) value = evaluate##Type(s, wo, wi);
  VKPT_GLOSSY_BSDFS(VKPT_EVALUATE)
#undef VKPT_EVALUATE
  return value;
}

// Whether a smooth BSDF scatters to wi at all: the shading normal and the triangle agree on a side that it reaches.
bool scattersTo(Surface s, Vec3 wi) {
  Float shading = dot(s.n, wi);
  Float geometric = dot(s.ng, wi);
  bool found = shading > 0.0 && geometric > 0.0;
  if (isRoughGlass(s.m.bsdf)) found = found || (shading < 0.0 && geometric < 0.0);
  return found;
}

// Weighs nothing where the surface doesn't scatter.
BsdfSample sampleBsdf(Surface s, Vec3 wo, UVec4 random) {
  BsdfSample b = specularSample(s.ng, Vec3(0.0));
  Vec3 u = Vec3(toUnit(random.x), toUnit(random.y), toUnit(random.z));
#define VKPT_SAMPLE(Name, Type) if (kEffect##Name && s.m.bsdf == kBsdf##Type) b = sample##Type(s, wo, u);
  VKPT_BSDFS(VKPT_SAMPLE)
#undef VKPT_SAMPLE
  if (!b.specular && !scattersTo(s, b.wi)) b.weight = Vec3(0.0);
  return b;
}
