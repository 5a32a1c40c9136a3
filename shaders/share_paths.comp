#version 460
#extension GL_GOOGLE_include_directive : require
// Where pixels share paths: the samples of a batch whose paths have ended, in three steps (lib/reuse.glsl).

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

layout(local_size_x = 64) in; // kBlockPixels
layout(constant_id = 72) const uint kStep = kStepConnect; // kConstantShareStep

// A lane for every slot, sample and member of its cluster.
void connectAll() {
  g_sample = job.firstSample + gl_WorkGroupID.y;
  uint shift = clusterShift(g_sample);
  g_slot = slotByCluster(gl_GlobalInvocationID.x, shift);
  g_pixel = secondVertex(slotOfMember(g_slot, gl_WorkGroupID.z, shift), g_sample).pixel; // that a fault is found by
  g_bounce = 1u;
  connectPaths(g_slot, g_sample, gl_WorkGroupID.z);
  addShadowRays();
}

// A lane for every slot.
void addUp() {
  uint slot = gl_GlobalInvocationID.x;
  uint x;
  uint y;
  if (!pixelOfSlot(slot, x, y)) return;
  uint pixel = y * frame.width + x;
  vec3 mean = vec3(0.0);
  vec3 deviations = vec3(0.0);
  uint before = subgroupMaximum(job.firstSample % kSamplesPerGroup);
  if (before != 0u) {
    mean = filmColour(kFilmOpenMean, pixel);
    deviations = filmColour(kFilmOpenDeviations, pixel);
  }
  uint count = subgroupMaximum(job.sampleCount);
  uint i = 0u;
  do {
    vec3 L = sharedValue(slot, job.firstSample + i);
    i += 1u;
    addSample(mean, deviations, float(before + i), L);
  } while (i < count);
  pathPlanes[statePlane(4u, slot)] = uvec4(floatBitsToUint(mean), 0u);
  pathPlanes[statePlane(5u, slot)] = uvec4(floatBitsToUint(deviations), 0u);
}

void main() {
  if (kStep == kStepConnect) connectAll();
  if (kStep == kStepBalance) balancePaths(gl_GlobalInvocationID.x, job.firstSample + gl_WorkGroupID.y);
  if (kStep == kStepAddUp) addUp();
}
