#version 460
#extension GL_GOOGLE_include_directive : require
// One iteration of path tracing for a tile: a batch of samples for every pixel of it. A lane whose path has ended
// starts its pixel's next sample, so that no lane waits for the longest path; and none waits long for another's ray:
// the subgroup shades when most of its lanes have their hits, and the others go on with their rays after that. What
// does not fit into the step budget is saved, listed, and goes on in the next dispatch.

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

layout(local_size_x = 64) in; // kBlockPixels

// A subgroup shades when so many eighths of its lanes have their hits. Shading costs as much as eight nodes; by the
// number of iterations on the Cornell boxes 4 and 6 would be 2 % slower.
const uint kLanesWaiting = 5u;

// What a lane works on: one pixel's samples of this batch.
struct Work {
  uint slot;
  uint pixel;
  uint x;
  uint y;
  uint begun;      // samples whose paths have started
  uint done;       // samples finished
  vec3 mean;       // of the open group of samples, those of earlier batches included
  vec3 deviations; // sum of squared deviations from it
};

uint randomKey() { return frame.seed ^ (job.firstSampleHigh * 0x9E3779B9u); }

Path nextPath(Work work) { return cameraPath(work.pixel, work.x, work.y, job.firstSample + work.begun, randomKey()); }

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
  work.begun = 0u;
  work.done = 0u;
  work.mean = vec3(0.0);
  work.deviations = vec3(0.0);
  path = nextPath(work);
  if (any && !fresh) loadPath(work, path);
  if (any && fresh && job.firstSample % kSamplesPerGroup != 0u) {
    work.mean = filmColour(kFilmOpenMean, work.pixel);
    work.deviations = filmColour(kFilmOpenDeviations, work.pixel);
  }
  work.begun = work.done + 1u;
  return any && work.done < job.sampleCount;
}

void finishSample(inout Work work, vec3 L) {
  if (!(isFinite(L.x) && isFinite(L.y) && isFinite(L.z))) {
    reportNonFinite();
    L = vec3(0.0); // counts as a sample of 0; the fault is reported
  }
  work.done += 1u;
  float n = float(job.firstSample % kSamplesPerGroup + work.done);
  addSample(work.mean, work.deviations, n, L);
}

// A lane's rays, traced one after the other: the shadow ray of the vertex that it left, then the ray to the next one.
// The light of that vertex is gathered when both have ended, by when its path may be over and the next one under way.
struct Rays {
  Traversal traversal;
  bool onPath; // there is a path whose ray follows the shadow ray
  DirectLight direct;
  bool occluded;
  bool shadowCut;
  bool pathOver; // `direct` belongs to a path that is over, of which these are left:
  vec3 overL;
  float overWeight;
};

Rays noRays(bool onPath) {
  Rays rays;
  rays.onPath = onPath;
  rays.direct = noDirectLight();
  rays.occluded = false;
  rays.shadowCut = false;
  rays.pathOver = false;
  rays.overL = vec3(0.0);
  rays.overWeight = 0.0;
  return rays;
}

Traversal beginPathRay(Path path, bool onPath) {
  Traversal t = beginClosest(path.ray);
  if (!onPath) t.current = kTraversalDone;
  return t;
}

void beginRays(inout Rays rays, Path path) {
  bool shadow = rays.direct.end > 0.0;
  Ray ray = path.ray;
  if (shadow) ray = rays.direct.shadow;
  rays.traversal = beginTraversal(ray, shadow ? rays.direct.end : kFarAway);
  if (shadow) lookForAny(rays.traversal, rays.direct.target);
  if (!shadow && !rays.onPath) rays.traversal.current = kTraversalDone;
}

bool raysEnded(Rays rays) { return !rays.traversal.anyHit && traversalEnded(rays.traversal, kMaxTraversalSteps); }

// A step of whichever ray is under way.
void stepRays(inout Rays rays, Path path) {
  stepTraversal(rays.traversal);
  if (rays.traversal.anyHit && traversalEnded(rays.traversal, kMaxTraversalSteps)) {
    rays.occluded = rays.traversal.hit.triangle != kNoTriangle;
    rays.shadowCut = traversalCut(rays.traversal);
    rays.traversal = beginPathRay(path, rays.onPath);
  }
}

// Goes on until most of the lanes have their hits.
void traceRays(inout Rays rays, Path path, uint lanes) {
  do {
    stepRays(rays, path);
    g_steps += 1u;
  } while (8u * subgroupAdd(raysEnded(rays) ? 1u : 0u) < kLanesWaiting * lanes);
}

void traceShadowRay(inout Rays rays, Path path) {
  do {
    if (rays.traversal.anyHit) stepRays(rays, path);
  } while (rays.traversal.anyHit);
}

// The light of the vertex before, and with it perhaps the end of a sample.
void gatherLight(inout Work work, inout Path path, inout Rays rays) {
  reportShadowRay(rays.direct.end > 0.0);
  if (rays.shadowCut) reportCut();
  Path owner = path;
  if (rays.pathOver) {
    owner.L = rays.overL;
    owner.filterWeight = rays.overWeight;
  }
  gatherDirect(owner, rays.direct, rays.occluded);
  if (rays.pathOver) finishSample(work, sampleValue(owner));
  if (!rays.pathOver) path.L = owner.L;
  Traversal t = rays.traversal;
  rays = noRays(rays.onPath);
  rays.traversal = t;
}

// The next vertex, or the start of the next path.
void shade(inout Work work, inout Path path, inout Rays rays) {
  g_sample = path.sampleLow;
  g_bounce = path.bounce;
  reportClosestRay();
  if (traversalCut(rays.traversal)) reportCut();
  if (!extendPath(path, rays.traversal.hit, rays.direct)) {
    rays.pathOver = true;
    rays.overL = path.L;
    rays.overWeight = path.filterWeight;
    rays.onPath = work.begun < job.sampleCount;
    path = nextPath(work);
    work.begun += 1u;
  }
  beginRays(rays, path);
}

// Whether enough lanes of the subgroup are still at work. The others' places are filled again by the next
// dispatch, which packs the unfinished slots; the last few go on to their end.
bool wellFilled(uint lanes) { return job.packs == 0u || 4u * lanes >= 3u * gl_SubgroupSize; }

void main() {
  Work work;
  Path path;
  bool working = startWork(work, path);
  bool started = working;
  Rays rays = noRays(working);
  beginRays(rays, path);
  if (working) {
    bool goesOn = true;
    uint lanes = subgroupAdd(1u);
    do {
      traceRays(rays, path, lanes);
      if (raysEnded(rays)) {
        gatherLight(work, path, rays);
        if (rays.onPath) shade(work, path, rays);
      }
      g_steps += 1u;
      working = work.done < job.sampleCount;
      goesOn = working && g_steps < kStepBudget;
      lanes = subgroupAdd(goesOn ? 1u : 0u);
    } while (goesOn && wellFilled(lanes));
    // What the ray to the next vertex has met so far is forgotten; it starts again in the next dispatch.
    if (working) {
      traceShadowRay(rays, path);
      gatherLight(work, path, rays);
      working = work.done < job.sampleCount;
    }
  }
  if (started) savePath(work, path);
  if (working) {
    uint place = atomicAdd(counters.unfinished, 1u);
    slotLists[job.listTurn * job.slotCount + place] = work.slot;
  }
  addCounters(working && path.bounce > 0u);
}
