#version 460
#extension GL_GOOGLE_include_directive : require
// Runs one of the library's sampling routines, a sample a lane, or evaluates a BSDF (tests/bsdf/probe.h).

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

layout(local_size_x = 64) in;

layout(constant_id = 100) const uint kRoutine = 0u;

struct Query {
  vec4 a; // BSDFs: wo, material; lights: the point they are seen from
  vec4 b; // normal; BSDFs: 1 on the material's front
};
layout(set = 0, binding = kBindingCount, std430) readonly buffer QueryBlock {
  Query query;
  vec4 directions[]; // to evaluate
};
struct Answer {
  vec4 a;
  vec4 b;
};
layout(set = 0, binding = kBindingCount + 1u, std430) writeonly buffer AnswerBlock { Answer answers[]; };

Surface surfaceOfQuery() {
  Surface s;
  s.p = vec3(0.0);
  s.error = vec3(0.0);
  s.ng = query.b.xyz;
  s.n = s.ng;
  s.front = query.b.w > 0.0;
  s.m = material(uint(query.a.w));
  return s;
}

Answer sampledBsdf(uvec4 random) {
  Surface s = surfaceOfQuery();
  BsdfSample b = sampleBsdf(s, query.a.xyz, random);
  return Answer(vec4(b.wi, b.pdf_w), vec4(b.weight, 0.0));
}

Answer evaluatedBsdf(uint i) {
  BsdfValue value = evaluateBsdf(surfaceOfQuery(), query.a.xyz, directions[i].xyz);
  return Answer(vec4(value.f, value.pdf_w), vec4(0.0));
}

Answer sampledLight(uvec4 random, uvec4 more) {
  LightSample light = sampleLight(query.a.xyz, query.b.xyz, random, more);
  float kind = light.triangle >= kLightEnvironment ? -float(light.triangle - kLightEnvironment + 1u) : float(light.triangle);
  return Answer(vec4(light.wi, light.pdf_w), vec4(light.end, kind));
}

Answer sampledEnvironment(uvec4 random) {
  EnvironmentSample e = sampleEnvironment(random);
  return Answer(vec4(e.wi, e.pdf_w), vec4(e.L, environmentAt(e.wi).pdf_w));
}

Answer sampledFilter(uvec4 random) {
  FilterSample f = sampleFilter(toUnit(random.x));
  return Answer(vec4(f.offset, f.weight, 0.0, 0.0), vec4(0.0));
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= job.slotCount) return;
  uvec4 random = pcg4d(uvec4(i, job.firstSample, kRoutine, 1u));
  uvec4 more = pcg4d(uvec4(i, job.firstSample, kRoutine, 2u));
  if (kRoutine == 0u) answers[i] = sampledBsdf(random);
  if (kRoutine == 1u) answers[i] = evaluatedBsdf(i);
  if (kRoutine == 2u) answers[i] = sampledLight(random, more);
  if (kRoutine == 3u) answers[i] = sampledEnvironment(random);
  if (kRoutine == 4u) answers[i] = sampledFilter(random);
}
