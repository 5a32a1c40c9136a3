#version 460
#extension GL_GOOGLE_include_directive : require
// One iteration of path tracing for a tile: a batch of samples for every pixel of it. A lane whose path has ended
// starts its pixel's next sample, so that no lane waits for the longest path. What does not fit into the step
// budget is saved, listed, and goes on in the next dispatch.

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

layout(local_size_x = 64) in; // kBlockPixels

// What a lane works on: one pixel's samples of this batch.
struct Work {
  uint slot;
  uint pixel;
  uint x;
  uint y;
  uint done;       // samples finished
  vec3 mean;       // of the open group of samples, those of earlier batches included
  vec3 deviations; // sum of squared deviations from it
};

uint randomKey() { return frame.seed ^ MUTATE(SampleHighIgnored, job.firstSampleHigh * 0x9E3779B9u, 0u); }

Path nextPath(Work work) { return cameraPath(work.pixel, work.x, work.y, job.firstSample + work.done, randomKey()); }

vec3 filmColour(uint plane, uint pixel) {
  return vec3(uintBitsToFloat(film[plane].values[pixel]), uintBitsToFloat(film[plane + 1u].values[pixel]),
              uintBitsToFloat(film[plane + 2u].values[pixel]));
}

void savePath(Work work, Path path) {
  uint flags = (path.emit ? 1u : 0u) | (path.waiting << 1u) | (path.history << 8u);
  pathPlanes[statePlane(0u, work.slot)] = uvec4(floatBitsToUint(path.ray.o), work.done);
  pathPlanes[statePlane(1u, work.slot)] = uvec4(floatBitsToUint(path.ray.d), path.ray.exclude);
  pathPlanes[statePlane(2u, work.slot)] = uvec4(floatBitsToUint(path.beta), path.bounce | (path.branch << 14u));
  pathPlanes[statePlane(3u, work.slot)] = uvec4(floatBitsToUint(path.L), flags);
  pathPlanes[statePlane(4u, work.slot)] = uvec4(floatBitsToUint(work.mean), floatBitsToUint(path.pdf_w));
  pathPlanes[statePlane(5u, work.slot)] = uvec4(floatBitsToUint(work.deviations), floatBitsToUint(path.filterWeight));
}

void loadPath(inout Work work, inout Path path) {
  uvec4 a = pathPlanes[statePlane(0u, work.slot)];
  uvec4 b = pathPlanes[statePlane(1u, work.slot)];
  uvec4 c = pathPlanes[statePlane(2u, work.slot)];
  uvec4 d = pathPlanes[statePlane(3u, work.slot)];
  uvec4 e = pathPlanes[statePlane(4u, work.slot)];
  uvec4 f = pathPlanes[statePlane(5u, work.slot)];
  path.ray.o = uintBitsToFloat(a.xyz);
  work.done = a.w;
  path.ray.d = uintBitsToFloat(b.xyz);
  path.ray.exclude = b.w;
  path.beta = MUTATE(CarriedThroughputLost, uintBitsToFloat(c.xyz), vec3(1.0));
  path.bounce = c.w & 0x3FFFu;
  path.branch = c.w >> 14u;
  path.L = uintBitsToFloat(d.xyz);
  path.emit = MUTATE(CarriedEmitLost, (d.w & 1u) != 0u, true);
  path.waiting = MUTATE(CarriedBranchLost, (d.w >> 1u) & 127u, 0u);
  path.history = MUTATE(CarriedHistoryLost, d.w >> 8u, kHistoryEye);
  path.sampleLow = job.firstSample + work.done;
  work.mean = uintBitsToFloat(e.xyz);
  path.pdf_w = MUTATE(CarriedPdfLost, uintBitsToFloat(e.w), 0.0);
  work.deviations = uintBitsToFloat(f.xyz);
  path.filterWeight = uintBitsToFloat(f.w);
}

// Returns whether this lane has work at all.
bool startWork(out Work work, out Path path) {
  uint lane = gl_GlobalInvocationID.x;
  bool fresh = job.fresh != 0u;
  bool any = fresh || lane < job.listed;
  work.slot = fresh || !any ? lane : slotLists[(1u - job.listTurn) * job.slotCount + lane];
  any = pixelOfSlot(work.slot, work.x, work.y) && any;
  work.pixel = work.y * frame.width + work.x;
  g_slot = work.slot;
  g_pixel = work.pixel;
  work.done = 0u;
  work.mean = vec3(0.0);
  work.deviations = vec3(0.0);
  path = nextPath(work);
  if (any && !fresh) loadPath(work, path);
  if (any && fresh && job.firstSample % kSamplesPerGroup != 0u) {
    work.mean = filmColour(kFilmOpenMean, work.pixel);
    work.deviations = filmColour(kFilmOpenDeviations, work.pixel);
  }
  return any && work.done < job.sampleCount;
}

void finishSample(inout Work work, vec3 L) {
  if (!(isFinite(L.x) && isFinite(L.y) && isFinite(L.z))) {
    if (MUTATE(FaultsHidden, true, false)) reportNonFinite();
    L = vec3(0.0); // counts as a sample of 0; the fault is reported
  }
  work.done += 1u;
  float n = float(job.firstSample % kSamplesPerGroup + work.done);
  addSample(work.mean, work.deviations, n, L);
}

// Whether enough lanes of the subgroup are still at work. The others' places are filled again by the next
// dispatch, which packs the unfinished slots; the last few go on to their end.
bool wellFilled() { return job.packs == 0u || 4u * subgroupAdd(1u) >= 3u * gl_SubgroupSize; }

void main() {
  Work work;
  Path path;
  bool working = startWork(work, path);
  bool started = working;
  if (working) {
    do {
      g_sample = path.sampleLow;
      g_bounce = path.bounce;
      if (!Li(path)) {
        finishSample(work, sampleValue(path));
        path = nextPath(work);
      }
      g_steps = subgroupMaximum(g_steps + 1u); // lanes that cast no shadow ray pay for those that did
      working = work.done < job.sampleCount;
    } while (working && g_steps < kStepBudget && wellFilled());
  }
  if (started) savePath(work, path);
  if (working) {
    uint place = atomicAdd(counters.unfinished, 1u);
    slotLists[job.listTurn * job.slotCount + place] = work.slot;
  }
  addCounters(working && path.bounce > 0u);
}
