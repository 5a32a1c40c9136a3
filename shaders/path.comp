#version 460
#extension GL_GOOGLE_include_directive : require
// One iteration of path tracing for a tile: a batch of samples for every pixel of it. A lane whose path has ended
// starts its pixel's next sample, so that no lane waits for the longest path. What does not fit into the
// iteration budget is saved and goes on in the next dispatch.

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

layout(local_size_x = 64) in; // kBlockPixels

void savePath(uint slot, Path path, uint done, vec3 mean, vec3 deviations) {
  uint n = job.slotCount;
  pathPlanes[slot] = uvec4(floatBitsToUint(path.ray.o), done);
  pathPlanes[slot + n] = uvec4(floatBitsToUint(path.ray.d), path.ray.exclude);
  pathPlanes[slot + 2u * n] = uvec4(floatBitsToUint(path.beta), path.bounce);
  pathPlanes[slot + 3u * n] = uvec4(floatBitsToUint(path.L), path.emit ? 1u : 0u);
  pathPlanes[slot + 4u * n] = uvec4(floatBitsToUint(mean), 0u);
  pathPlanes[slot + 5u * n] = uvec4(floatBitsToUint(deviations), 0u);
}

void main() {
  uint slot = gl_GlobalInvocationID.x;
  uint x;
  uint y;
  bool inImage = pixelOfSlot(slot, x, y);
  uint pixel = y * frame.width + x;
  // Within a group of samples the running mean is kept in float; it goes on where the last batch stopped.
  uint before = job.firstSample % kSamplesPerGroup;
  uint key = frame.seed ^ (job.firstSampleHigh * 0x9E3779B9u);

  Path path;
  uint done;
  vec3 mean;
  vec3 deviations;
  if (job.fresh != 0u) {
    done = inImage ? 0u : job.sampleCount;
    path = cameraPath(pixel, x, y, job.firstSample, key);
    mean = vec3(0.0);
    deviations = vec3(0.0);
    if (inImage && before != 0u) {
      mean = vec3(uintBitsToFloat(film[kFilmOpenMean].values[pixel]), uintBitsToFloat(film[kFilmOpenMean + 1u].values[pixel]),
                  uintBitsToFloat(film[kFilmOpenMean + 2u].values[pixel]));
      deviations = vec3(uintBitsToFloat(film[kFilmOpenDeviations].values[pixel]), uintBitsToFloat(film[kFilmOpenDeviations + 1u].values[pixel]),
                  uintBitsToFloat(film[kFilmOpenDeviations + 2u].values[pixel]));
    }
  } else {
    uint n = job.slotCount;
    uvec4 a = pathPlanes[slot];
    uvec4 b = pathPlanes[slot + n];
    uvec4 c = pathPlanes[slot + 2u * n];
    uvec4 d = pathPlanes[slot + 3u * n];
    path.ray.o = uintBitsToFloat(a.xyz);
    done = a.w;
    path.ray.d = uintBitsToFloat(b.xyz);
    path.ray.exclude = b.w;
    path.beta = uintBitsToFloat(c.xyz);
    path.bounce = c.w;
    path.L = uintBitsToFloat(d.xyz);
    path.emit = d.w != 0u;
    path.pixel = pixel;
    path.sampleLow = job.firstSample + done;
    path.key = key;
    mean = uintBitsToFloat(pathPlanes[slot + 4u * n].xyz);
    deviations = uintBitsToFloat(pathPlanes[slot + 5u * n].xyz);
  }

  bool working = done < job.sampleCount;
  if (working) {
    do {
      bool goesOn = Li(path);
      if (!goesOn) {
        vec3 L = path.L;
        if (!(isFinite(L.x) && isFinite(L.y) && isFinite(L.z))) {
          reportNonFinite();
          L = vec3(0.0); // counts as a sample of 0; the fault is reported
        }
        done += 1u;
        addSample(mean, deviations, float(before + done), L);
        path = cameraPath(pixel, x, y, job.firstSample + done, key);
      }
      g_steps += 1u;
      working = done < job.sampleCount;
    } while (working && g_steps < kIterationBudget);
  }
  savePath(slot, path, done, mean, deviations);

  uint unfinished = subgroupAdd(working ? 1u : 0u);
  uint carried = subgroupAdd(working && path.bounce > 0u ? 1u : 0u);
  uint raysClosest = subgroupAdd(g_raysClosest);
  uint raysShadow = subgroupAdd(g_raysShadow);
  uint capped = subgroupAdd(g_cappedPaths);
  uint nonFinite = subgroupAdd(g_nonFinite);
  uint cut = subgroupAdd(g_cutTraversals);
  uint overflow = subgroupAdd(g_stackOverflows);
  if (subgroupElect()) {
    atomicAdd(counters.unfinished, unfinished);
    atomicAdd(counters.carriedPaths, carried);
    atomicAdd(counters.raysClosest, raysClosest);
    atomicAdd(counters.raysShadow, raysShadow);
    atomicAdd(counters.cappedPaths, capped);
    atomicAdd(counters.nonFinite, nonFinite);
    atomicAdd(counters.cutTraversal, cut);
    atomicAdd(counters.stackOverflow, overflow);
  }
}
