#version 460
#extension GL_GOOGLE_include_directive : require
// One iteration of path tracing for a tile: a batch of samples for every pixel of it, paths from the eye or, specialised
// by kFromLight, from the lights. A lane whose path has ended
// starts its pixel's next sample, so that no lane waits for the longest path; and none waits long for another's ray:
// the subgroup shades when most of its lanes have their hits, and the others go on with their rays after that. What
// does not fit into the step budget is saved, listed, and goes on in the next dispatch.
//
// Where pixels share paths, these have been begun by first_vertices.comp, and share_paths.comp makes samples of them.

#include "shared/language.h"
#include "shared/structs.h"
#include "shared/effects.h"
#include "lib/records.glsl"
#include "device_memory.glsl"
#include "lib/library.glsl"

#ifdef VKPT_PRIMARY // another build: what the camera's rays meet, in the same film by the same way
layout(constant_id = 67) const uint kPrimaryView = kPrimaryBaseColour; // kConstantPrimaryView
#include "lib/primary.glsl"
#define VKPT_EXTEND extendPrimary
#else
#define VKPT_EXTEND extendPath
#endif

#include "begun_paths.glsl"

layout(local_size_x = 64) in; // kBlockPixels

bool pathsAreBegun() { return reusesPaths() && !kFromLight; }

// A subgroup shades when so many eighths of its lanes have their hits. Shading costs as much as eight nodes; by the
// number of iterations on the Cornell boxes 4 and 6 would be 2 % slower.
const uint kLanesWaiting = 5u;

// What a lane works on: one pixel's samples of this batch.
struct Work {
  uint slot;
  uint pixel;
  uint x;
  uint y;
  uint open;       // bit i: sample i is to be done; the lowest: its path is under way
  vec3 mean;       // of the open group of samples, those of earlier batches included
  vec3 deviations; // sum of squared deviations from it
};

Path pathOfSample(Work work, uint i) {
  if (kFromLight) return lightPath(work.pixel, job.firstSample + i, randomKey());
  if (pathsAreBegun()) return begunPath(work.slot, work.pixel, job.firstSample + i);
  return cameraPath(work.pixel, work.x, work.y, job.firstSample + i, randomKey());
}

// Which samples of the batch need work, a bit each: of those that take a path from a light, the ones that may become
// caustics; of those that are begun, the ones that go on. All lanes look at all of theirs together: later, one by one,
// the others would have to wait.
uint samplesToDo(Work work) {
  uint all = (1u << job.sampleCount) - 1u;
  if (!kFromLight && !pathsAreBegun()) return all;
  uint some = 0u;
  uint count = subgroupMaximum(job.sampleCount);
  uint i = 0u;
  do {
    bool wanted = pathsAreBegun() ? begunPathGoesOn(work.slot, job.firstSample + i)
                                  : mayBecomeCaustic(pathOfSample(work, i).ray);
    if (wanted) some |= 1u << i;
    i += 1u;
  } while (i < count);
  g_steps += count;
  return some & all;
}

uint nextSample(Work work) { return work.open == 0u ? 0u : uint(findLSB(work.open)); }

uint vertexPlane() { return kPathPlanes + splitDepth() * kBranchPlanes; } // behind the branches

void savePath(Work work, Path path) {
  PathTexels t = packPath(path, work.open);
  pathPlanes[statePlane(0u, work.slot)] = t.origin;
  pathPlanes[statePlane(1u, work.slot)] = t.direction;
  pathPlanes[statePlane(2u, work.slot)] = t.throughput;
  pathPlanes[statePlane(3u, work.slot)] = t.light;
  pathPlanes[statePlane(4u, work.slot)] = uvec4(floatBitsToUint(work.mean), floatBitsToUint(path.pdf_w));
  pathPlanes[statePlane(5u, work.slot)] = uvec4(floatBitsToUint(work.deviations), floatBitsToUint(path.sampleWeight));
  if (kEffectLightTree) {
    pathPlanes[statePlane(vertexPlane(), work.slot)] = uvec4(floatBitsToUint(path.from), path.fromTable);
    pathPlanes[statePlane(vertexPlane() + 1u, work.slot)] = uvec4(floatBitsToUint(path.fromNormal), 0u);
  }
}

void loadPath(inout Work work, inout Path path) {
  PathTexels t = PathTexels(pathPlanes[statePlane(0u, work.slot)], pathPlanes[statePlane(1u, work.slot)],
                            pathPlanes[statePlane(2u, work.slot)], pathPlanes[statePlane(3u, work.slot)]);
  uvec4 e = pathPlanes[statePlane(4u, work.slot)];
  uvec4 f = pathPlanes[statePlane(5u, work.slot)];
  unpackPath(path, t);
  path.beta = MUTATE(CarriedThroughputLost, path.beta, vec3(1.0));
  path.reuse = MUTATE(CarriedReuseLost, path.reuse, kReuseAlone);
  work.open = spareBits(t);
  path.sampleLow = job.firstSample + nextSample(work);
  work.mean = uintBitsToFloat(e.xyz);
  path.pdf_w = MUTATE(CarriedPdfLost, uintBitsToFloat(e.w), 0.0);
  work.deviations = uintBitsToFloat(f.xyz);
  path.sampleWeight = uintBitsToFloat(f.w);
  if (kEffectLightTree) {
    uvec4 from = pathPlanes[statePlane(vertexPlane(), work.slot)];
    path.from = uintBitsToFloat(from.xyz);
    path.fromTable = MUTATE(CarriedTableLost, from.w, 0u);
    path.fromNormal = uintBitsToFloat(pathPlanes[statePlane(vertexPlane() + 1u, work.slot)].xyz);
  }
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
  work.open = fresh ? samplesToDo(work) : 0u;
  work.mean = vec3(0.0);
  work.deviations = vec3(0.0);
  path = pathOfSample(work, nextSample(work));
  if (any && !fresh) loadPath(work, path);
  if (any && fresh && !reusesPaths() && job.firstSample % kSamplesPerGroup != 0u) {
    work.mean = filmColour(kFilmOpenMean, work.pixel);
    work.deviations = filmColour(kFilmOpenDeviations, work.pixel);
  }
  if (kEffectKindImages && any) loadKinds();
  return any && work.open != 0u;
}

// owner: the path of the sample that is done.
void finishSample(inout Work work, Path owner) {
  vec3 L = countedLight(finishedLight(owner));
  if (kFromLight) return; // what it has brought lies with other pixels
  if (reusesPaths()) {
    storePathsLight(owner, L);
  } else {
    uint done = job.sampleCount - uint(bitCount(work.open)); // of this batch
    addSample(work.mean, work.deviations, float(job.firstSample % kSamplesPerGroup + done), L);
  }
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
  uint overReuse;
  uint overSample;
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
  rays.overReuse = kReuseNone;
  rays.overSample = 0u;
  return rays;
}

void beginPathRay(inout Rays rays, Path path) {
  beginAgain(rays.traversal, path.ray, rays.onPath ? kFarAway : 0.0);
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
    beginPathRay(rays, path);
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
    owner.sampleWeight = rays.overWeight;
    owner.reuse = rays.overReuse;
    owner.sampleLow = rays.overSample;
  }
  gatherDirect(owner, rays.direct, rays.occluded);
  if (rays.pathOver) finishSample(work, owner);
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
  if (!VKPT_EXTEND(path, rays.traversal.hit, rays.direct)) {
    // Of the same sample or of the next.
    uint others = work.open & (work.open - 1u);
    bool last = path.repeat + 1u >= path.repeats || !kEffectSpecularSamples;
    if (last) work.open = others;
    Path fresh = pathOfSample(work, nextSample(work));
    if (pathsAreBegun() && !last) fresh = cameraPath(work.pixel, work.x, work.y, path.sampleLow, path.key);
    if (!startAgainFrom(fresh, path)) {
      rays.pathOver = true;
      rays.overL = path.L;
      rays.overWeight = path.sampleWeight;
      rays.overReuse = path.reuse;
      rays.overSample = path.sampleLow;
      rays.onPath = work.open != 0u;
      path = fresh;
    }
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
      if (kEffectLightSamples || (kEffectLightTree && kBelowLightTables)) g_steps = subgroupMaximum(g_steps); // some lanes' shading counts, too
      working = work.open != 0u || rays.pathOver;
      goesOn = working && g_steps < kStepBudget;
      lanes = subgroupAdd(goesOn ? 1u : 0u);
    } while (goesOn && wellFilled(lanes));
    // What the ray to the next vertex has met so far is forgotten; it starts again in the next dispatch.
    if (working) {
      traceShadowRay(rays, path);
      gatherLight(work, path, rays);
      working = work.open != 0u;
    }
  }
  if (started) savePath(work, path);
  if (kEffectKindImages && started) storeKinds();
  if (working) {
    uint place = atomicAdd(counters.unfinished, 1u);
    slotLists[job.listTurn * job.slotCount + place] = work.slot;
  }
  addCounters(working && path.bounce > 0u);
}
