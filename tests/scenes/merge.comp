#version 460
#extension GL_GOOGLE_include_directive : require
// Merges the groups of 64 streams by the film's mergeGroup(), one stream a lane. Built with VKPT_MUTATIONS.

#include "shared/language.h"
#include "shared/structs.h"
#include "lib/film.glsl"

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer GroupBlock { vec2 groups[]; }; // mean, deviations
layout(set = 0, binding = 1, std430) writeonly buffer MergedBlock { vec4 merged[]; }; // two pairs

void main() {
  uint stream = gl_LocalInvocationID.x;
  uint count = uint(groups.length()) / 64u;
  Pair mean = makePair(0.0, 0.0);
  Pair deviations = makePair(0.0, 0.0);
  for (uint g = 0u; g < count; ++g) {
    vec2 group = groups[g * 64u + stream];
    mergeGroup(mean, deviations, g * kSamplesPerGroup, group.x, group.y, kSamplesPerGroup);
  }
  merged[stream] = vec4(mean.high, mean.low, deviations.high, deviations.low);
}
