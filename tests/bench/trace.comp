#version 460
#extension GL_GOOGLE_include_directive : require
// Traces recorded rays (tests/bench/rays.h) by the shipped traversal alone, and as path.comp traces its own: a lane that has
// its hit takes the next ray, and does not wait for the longest one.

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 100) const uint kShadow = 0u; // 1: any hit before tMax, 0: closest hit
layout(constant_id = 101) const uint kRaysPerLane = 1u;

layout(set = 0, binding = kBindingCount, rgba32ui) uniform readonly restrict uimageBuffer rayTexels;
layout(set = 0, binding = kBindingCount + 1u, std430) buffer ResultBlock { float results[]; };

// Half of a subgroup's lanes are to have their hits before these take rays: to begin one costs less than to shade.
const uint kLanesWaiting = 4u; // eighths

void beginRay(inout Traversal t, uint i) {
  uvec4 a = imageLoad(rayTexels, int(2u * i));
  uvec4 b = imageLoad(rayTexels, int(2u * i + 1u));
  Ray ray;
  ray.o = uintBitsToFloat(a.xyz);
  ray.d = uintBitsToFloat(b.xyz);
  ray.exclude = kShadow != 0u ? kNoTriangle : b.w;
  beginAgain(t, ray, kShadow != 0u ? uintBitsToFloat(a.w) : kFarAway);
  if (kShadow != 0u) lookForAny(t, b.w);
}

void main() {
  // Each subgroup has its own rays, side by side.
  uint subgroup = gl_WorkGroupID.x * gl_NumSubgroups + gl_SubgroupID;
  uint next = subgroup * gl_SubgroupSize * kRaysPerLane;
  uint end = min(next + gl_SubgroupSize * kRaysPerLane, job.slotCount);
  uint i = next + gl_SubgroupInvocationID;
  next += gl_SubgroupSize;
  if (i >= end) return;
  Traversal t;
  t.stack = emptyStack();
  t.hit.b1 = 0.0;
  t.hit.b2 = 0.0;
  beginRay(t, i);
  bool working = true;
  uint lanes = subgroupAdd(1u);
  do {
    do {
      stepTraversal(t);
    } while (8u * subgroupAdd(traversalEnded(t, kMaxTraversalSteps) ? 1u : 0u) < kLanesWaiting * lanes);
    uint ended = traversalEnded(t, kMaxTraversalSteps) ? 1u : 0u;
    uint before = subgroupExclusiveAdd(ended);
    uint all = subgroupAdd(ended);
    if (ended != 0u) {
      if (traversalCut(t)) reportCut();
      bool hits = t.hit.triangle != kNoTriangle;
      results[i] = kShadow == 0u ? t.hit.t : hits ? 1.0 : 0.0;
      i = next + before;
      working = i < end;
      beginRay(t, working ? i : 0u);
    }
    next += all;
    lanes = subgroupAdd(working ? 1u : 0u);
  } while (working);
}
