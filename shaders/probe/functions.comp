#version 460
#extension GL_GOOGLE_include_directive : require
// Runs one function of the library, or of the driver, on a row of arguments a lane (src/selftest/functions.h).

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 100) const uint kFunction = 0u;

struct Row {
  vec4 a;
  vec4 b;
};
// As bits: a small integer that passes as a float could be flushed to 0. Two a row.
layout(set = 0, binding = kBindingCount, std430) readonly buffer ArgumentBlock { uvec4 arguments[]; };
layout(set = 0, binding = kBindingCount + 1u, std430) writeonly buffer ResultBlock { uvec4 results[]; };

Material plainMaterial() {
  Material m;
  m.bsdf = kBsdfDiffuse;
  m.flags = 0u;
  m.reflectance = vec3(0.0);
  m.texture = kNoTexture;
  m.emission = vec3(0.0);
  m.lightPdf_A = 0.0;
  m.specular = vec3(1.0);
  m.roughness = 0.0;
  m.ior = 1.5;
  m.eta = vec3(1.0);
  m.k = vec3(0.0);
  m.absorption = vec3(0.0);
  return m;
}

// Seen from its front; the normal is +z.
Surface flatSurface(Material m) {
  Surface s;
  s.p = vec3(0.0);
  s.error = vec3(0.0);
  s.ng = vec3(0.0, 0.0, 1.0);
  s.n = s.ng;
  s.front = true;
  s.m = m;
  return s;
}

Row dielectric(Row x) {
  float cosT;
  float f = fresnelDielectric(x.a.x, x.a.y, cosT);
  return Row(vec4(f, cosT, fresnelTransmittance(x.a.x, cosT, x.a.y), 0.0), vec4(0.0));
}

Row conductor(Row x) { return Row(vec4(fresnelConductor(x.a.x, x.a.y, x.a.z), 0.0, 0.0, 0.0), vec4(0.0)); }

// a: wo, exponent; b: wi.
Row phongValue(Row x) {
  Material m = plainMaterial();
  m.roughness = x.a.w;
  BsdfValue v = evaluatePhong(flatSurface(m), x.a.xyz, x.b.xyz);
  return Row(vec4(v.f, v.pdf_w), vec4(0.0));
}

// a: wo, exponent; b: three random numbers.
Row phongSample(Row x) {
  Material m = plainMaterial();
  m.roughness = x.a.w;
  vec3 wi = samplePhong(flatSurface(m), x.a.xyz, x.b.xyz).wi;
  BsdfValue v = evaluatePhong(flatSurface(m), x.a.xyz, wi);
  return Row(vec4(wi, v.pdf_w), vec4(v.f, 0.0));
}

// Metal that reflects everything. a: wo, alpha; b: two random numbers, whether Beckmann's.
Row roughSample(Row x) {
  Material m = plainMaterial();
  m.roughness = x.a.w;
  m.k = vec3(1e4);
  m.flags = x.b.z > 0.0 ? kMaterialBeckmann : 0u;
  BsdfSample s = sampleRoughConductor(flatSurface(m), x.a.xyz, vec3(x.b.xy, 0.0));
  BsdfValue v = evaluateRoughConductor(flatSurface(m), x.a.xyz, s.wi);
  return Row(vec4(s.wi, s.pdf_w), vec4(s.weight.x, v.pdf_w, 0.0, 0.0));
}

// a: of one strategy, of the other.
Row weight(Row x) { return Row(vec4(misWeight(x.a.x, x.a.y), 0.0, 0.0, 0.0), vec4(0.0)); }

Row arithmetic(Row x) {
  return Row(vec4(x.a.x / x.a.y, sqrt(x.a.x), exp(x.a.z), log(x.a.x)),
             vec4(sin(x.a.w), cos(x.a.w), atan(x.a.z, x.a.w), pow(x.a.x, x.a.y)));
}

Row powers(Row x) { return Row(vec4(pow(x.a.x, x.a.y), exp(x.a.x), log(x.a.x), sqrt(x.a.x)), vec4(0.0)); }

// How minimum and maximum treat NaN, and the slab test's own, of distances.
Row extremes(Row x) {
  vec4 low = slabMin(vec4(x.a.x), vec4(x.a.y));
  vec4 high = slabMax(vec4(x.a.x), vec4(x.a.y));
  return Row(vec4(min(x.a.x, x.a.y), max(x.a.x, x.a.y), clamp(x.a.x, 0.0, 1.0), 0.0),
             vec4(low.x, high.x, isFinite(x.a.x) ? 1.0 : 0.0, x.a.x == x.a.x ? 1.0 : 0.0));
}

// Sums and products of numbers below the least normal one, and what a comparison makes of them.
Row denormals(Row x) {
  return Row(vec4(x.a.x + x.a.y, x.a.x * x.a.y, x.a.x, x.a.x > 0.0 ? 1.0 : 0.0), vec4(0.0));
}

// a.x a.y - a.z in one expression; and as the library's `precise` functions must have it.
Row contraction(Row x) {
  float loose = x.a.x * x.a.y - x.a.z * x.a.w;
  float forth = edgeFunction(vec3(x.a.x, x.a.z, 0.0), vec3(x.a.w, x.a.y, 0.0));
  float back = edgeFunction(vec3(x.a.w, x.a.y, 0.0), vec3(x.a.x, x.a.z, 0.0));
  Pair p = twoProduct(x.a.x, x.a.y);
  return Row(vec4(loose, forth, back, 0.0), vec4(p.high, p.low, 0.0, 0.0));
}

Row function(Row x) {
  if (kFunction == 0u) return dielectric(x);
  if (kFunction == 1u) return conductor(x);
  if (kFunction == 2u) return phongValue(x);
  if (kFunction == 3u) return phongSample(x);
  if (kFunction == 4u) return roughSample(x);
  if (kFunction == 5u) return weight(x);
  if (kFunction == 8u) return arithmetic(x);
  if (kFunction == 9u) return powers(x);
  if (kFunction == 10u) return extremes(x);
  if (kFunction == 11u) return denormals(x);
  return contraction(x);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (2u * i >= uint(arguments.length())) return;
  uvec4 a = arguments[2u * i];
  uvec4 b = arguments[2u * i + 1u];
  if (kFunction == 6u) { // a.x: 32 random bits
    results[2u * i] = uvec4(floatBitsToUint(toUnit(a.x)), 0u, 0u, 0u);
  } else if (kFunction == 7u) { // a: pixel, sample, block, key
    results[2u * i] = independentBlock(a.x, a.y, a.z, a.w);
  } else {
    Row r = function(Row(uintBitsToFloat(a), uintBitsToFloat(b)));
    results[2u * i] = floatBitsToUint(r.a);
    results[2u * i + 1u] = floatBitsToUint(r.b);
  }
}
