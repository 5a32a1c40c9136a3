#version 460
#extension GL_GOOGLE_include_directive : require
// Traces recorded rays (tests/bench/rays.h), one a lane, by the shipped traversal alone.

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 100) const uint kShadow = 0u; // 1: any hit before tMax, 0: closest hit

layout(set = 0, binding = kBindingCount, rgba32ui) uniform readonly restrict uimageBuffer rayTexels;
layout(set = 0, binding = kBindingCount + 1u, std430) buffer ResultBlock { float results[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= job.slotCount) return;
  uvec4 a = imageLoad(rayTexels, int(2u * i));
  uvec4 b = imageLoad(rayTexels, int(2u * i + 1u));
  Ray ray;
  ray.o = uintBitsToFloat(a.xyz);
  ray.d = uintBitsToFloat(b.xyz);
  if (kShadow != 0u) {
    ray.exclude = kNoTriangle;
    results[i] = traceOccluded(ray, uintBitsToFloat(a.w), b.w) ? 1.0 : 0.0;
  } else {
    ray.exclude = b.w;
    results[i] = traceClosest(ray).t;
  }
}
