#version 460
#extension GL_GOOGLE_include_directive : require
// Traces one path a lane by the estimator's Li() and records what it meets (src/selftest/record_paths.h).

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"
#include "probe/path_records.h"

layout(local_size_x = 64) in;

layout(set = 0, binding = kBindingCount, std430) writeonly buffer RecordBlock { PathRecord records[]; };

// As many steps as leave room for those of one more vertex, whose ray is traced twice, below the loop limit.
const uint kRecordBudget = 1000u;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= job.slotCount) return;
  g_slot = i;
  g_pixel = i;
  Path path = cameraPath(i, i % frame.width, i / frame.width, job.firstSample, frame.seed);
  uint vertices = 0u;
  bool goesOn = true;
  do {
    Hit hit = traceClosest(path.ray);
    uint front = 0u;
    if (hit.triangle != kNoTriangle && surfaceAt(hit, -path.ray.d).front) front = kVertexFront;
    vec3 direction = path.ray.d;
    vec3 before = path.L;
    goesOn = Li(path) || startAgain(path);
    if (vertices < kRecordedVertices) {
      VertexRecord v;
      v.direction = vec4(direction, hit.t);
      v.gathered = vec4(path.L - before, 0.0);
      v.triangle = hit.id;
      v.flags = front | (goesOn ? kVertexGoesOn : 0u);
      v.unused0 = 0u;
      v.unused1 = 0u;
      records[i].vertices[vertices] = v;
    }
    vertices += 1u;
    g_steps = subgroupMaximum(g_steps + 1u);
  } while (goesOn && g_steps < kRecordBudget);
  records[i].value = vec4(sampleValue(path), 0.0);
  records[i].count = vertices;
  records[i].unfinished = goesOn ? 1u : 0u;
  records[i].unused0 = 0u;
  records[i].unused1 = 0u;
}
