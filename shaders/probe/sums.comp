#version 460
#extension GL_GOOGLE_include_directive : require
// Eight known streams into the film's sums: groups of samples in float, merged in pairs (src/selftest/cases_m_sums.cpp
// makes the same numbers). A dispatch adds kGroups groups to each stream; so many dispatches, so long a stream.

#include "shared/language.h"
#include "shared/structs.h"
#include "lib/rng.glsl"
#include "lib/film.glsl"

layout(local_size_x = 8) in;

layout(constant_id = 100) const uint kGroups = 1u;

struct Stream {
  vec4 moments; // mean and deviations, each a pair
  uvec4 count;  // groups so far
};
layout(set = 0, binding = 0, std430) readonly buffer UnusedBlock { uint unused[]; };
layout(set = 0, binding = 1, std430) buffer StreamBlock { Stream streams[]; };

// Number i of a stream: a constant; uniform; uniform far from 0; rare and large.
float streamValue(uint stream, uint i) {
  float u = toUnit(pcg4d(uvec4(i, stream, 0u, 0u)).x);
  float value = 0.1;
  if (stream % 4u == 1u) value = u;
  if (stream % 4u == 2u) value = 1000.0 + u;
  if (stream % 4u == 3u) value = u < 0.001 ? 500.0 : 0.25;
  return value;
}

void main() {
  uint stream = gl_LocalInvocationID.x;
  vec4 moments = streams[stream].moments;
  uint first = streams[stream].count.x;
  Pair mean = makePair(moments.x, moments.y);
  Pair deviations = makePair(moments.z, moments.w);
  uint g = first;
  do {
    vec3 groupMean = vec3(0.0);
    vec3 groupDeviations = vec3(0.0);
    uint i = 0u;
    do {
      vec3 L = vec3(streamValue(stream, g * kSamplesPerGroup + i));
      i += 1u;
      addSample(groupMean, groupDeviations, float(i), L);
    } while (i < kSamplesPerGroup);
    mergeGroup(mean, deviations, g * kSamplesPerGroup, groupMean.x, groupDeviations.x, kSamplesPerGroup);
    g += 1u;
  } while (g < first + kGroups);
  streams[stream].moments = vec4(mean.high, mean.low, deviations.high, deviations.low);
  streams[stream].count = uvec4(g, 0u, 0u, 0u);
}
