// The device's memory behind the library's accessors: texel buffers, since lavapipe loads them 2-3 times faster
// than storage buffers. A program for another device changes this file and what it includes alone.
// Written as rgba32ui: a denormal float that carries an integer could be flushed to 0.

#include "lib/block.glsl"

#define VKPT_DECLARE_EFFECT(id, Name, name, what) layout(constant_id = id) const bool kEffect##Name = true;
VKPT_EFFECTS(VKPT_DECLARE_EFFECT)
layout(constant_id = 64) const uint kStackDepth = kMaxStackDepth; // kConstantStackDepth
layout(constant_id = 65) const uint kRouletteMode = 1u; // kConstantRouletteMode
layout(constant_id = 66) const uint kFilterShape = 0u; // kConstantFilterShape
layout(constant_id = 68) const uint kSampler = kSamplerIndependent; // kConstantSampler
layout(constant_id = 69) const bool kFromLight = false; // kConstantFromLight
layout(constant_id = 70) const bool kByLightTree = false; // kConstantByLightTree
layout(constant_id = 71) const uint kReuseEdge = 1u; // kConstantReuseEdge
layout(constant_id = 73) const bool kByLightTables = false; // kConstantByLightTables
layout(constant_id = 74) const uint kLightTableBits = 8u; // kConstantLightTableBits
layout(constant_id = 75) const bool kBelowLightTables = true; // kConstantBelowLightTables

layout(set = 0, binding = kBindingFrame, std140) uniform FrameBlock { FrameConstants frame; };

layout(set = 0, binding = kBindingNodes, rgba32ui) uniform readonly restrict uimageBuffer nodeTexels;
layout(set = 0, binding = kBindingTriangles, rgba32ui) uniform readonly restrict uimageBuffer triangleTexels;
layout(set = 0, binding = kBindingNormals, rgba32ui) uniform readonly restrict uimageBuffer normalTexels;
layout(set = 0, binding = kBindingMaterials, rgba32ui) uniform readonly restrict uimageBuffer materialTexels;
layout(set = 0, binding = kBindingLights, rgba32ui) uniform readonly restrict uimageBuffer lightTexels;
layout(set = 0, binding = kBindingLightNodes, rgba32ui) uniform readonly restrict uimageBuffer lightNodeTexels;
layout(set = 0, binding = kBindingUvs, rgba32ui) uniform readonly restrict uimageBuffer uvTexels;
layout(set = 0, binding = kBindingTextures, rgba32ui) uniform readonly restrict uimageBuffer textureTexels;
layout(set = 0, binding = kBindingEnvironment, rgba32ui) uniform readonly restrict uimageBuffer environmentTexels;
layout(set = 0, binding = kBindingGuide, r32ui) uniform readonly restrict uimageBuffer guideNumbers;
layout(set = 0, binding = kBindingLightGrid, r32ui) uniform readonly restrict uimageBuffer lightGridNumbers;

vec4 nodeBounds(uint node, uint row) {
  return uintBitsToFloat(imageLoad(nodeTexels, int(node * kTexelsPerNode + row)));
}
uvec4 nodeChildren(uint node) { return imageLoad(nodeTexels, int(node * kTexelsPerNode + 6u)); }

TriangleRecord triangleRecord(uint i) {
  uvec4 a = imageLoad(triangleTexels, int(i * kTexelsPerTriangle));
  uvec4 b = imageLoad(triangleTexels, int(i * kTexelsPerTriangle + 1u));
  uvec4 c = imageLoad(triangleTexels, int(i * kTexelsPerTriangle + 2u));
  TriangleRecord r;
  r.v0 = uintBitsToFloat(a.xyz);
  r.v1 = uintBitsToFloat(b.xyz);
  r.v2 = uintBitsToFloat(c.xyz);
  r.material = a.w;
  r.id = b.w;
  r.lightLeaf = c.w;
  return r;
}
vec3 triangleNormal(uint i, uint corner) {
  return uintBitsToFloat(imageLoad(normalTexels, int(i * kTexelsPerTriangle + corner)).xyz);
}
vec2 triangleUv(uint i, uint corner) {
  if (corner < 2u) {
    uvec4 a = imageLoad(uvTexels, int(i * kTexelsPerUv));
    return uintBitsToFloat(corner == 0u ? a.xy : a.zw);
  }
  return uintBitsToFloat(imageLoad(uvTexels, int(i * kTexelsPerUv + 1u)).xy);
}
Material material(uint i) {
  int first = int(i * kTexelsPerMaterial);
  uvec4 a = imageLoad(materialTexels, first);
  uvec4 b = imageLoad(materialTexels, first + 1);
  uvec4 c = imageLoad(materialTexels, first + 2);
  uvec4 d = imageLoad(materialTexels, first + 3);
  uvec4 e = imageLoad(materialTexels, first + 4);
  uvec4 f = imageLoad(materialTexels, first + 5);
  Material m;
  m.reflectance = uintBitsToFloat(a.xyz);
  m.bsdf = a.w & 0xFFFFu;
  m.flags = a.w >> 16u;
  m.emission = uintBitsToFloat(b.xyz);
  m.lightPdf_A = uintBitsToFloat(b.w);
  m.eta = uintBitsToFloat(c.xyz);
  m.roughness = uintBitsToFloat(c.w);
  m.k = uintBitsToFloat(d.xyz);
  m.ior = uintBitsToFloat(d.w);
  m.specular = uintBitsToFloat(e.xyz);
  m.texture = e.w;
  m.absorption = uintBitsToFloat(f.xyz);
  return m;
}
TextureRecord textureRecord(uint i) {
  uvec4 a = imageLoad(textureTexels, int(i));
  return TextureRecord(a.x, a.y, a.z);
}
vec3 texturePixel(uint pixel) {
  uvec4 pair = imageLoad(textureTexels, int(pixel / kPixelsPerTexel));
  uvec2 halves = (pixel & 1u) == 0u ? pair.xy : pair.zw;
  return vec3(unpackHalf2x16(halves.x), unpackHalf2x16(halves.y).x);
}
EnvironmentRecord environmentRecord(uint i) {
  uvec4 a = imageLoad(environmentTexels, int(i * kTexelsPerEnvironmentTexel));
  uvec4 b = imageLoad(environmentTexels, int(i * kTexelsPerEnvironmentTexel + 1u));
  EnvironmentRecord r;
  r.radiance = uintBitsToFloat(a.xyz);
  r.pdf_w = uintBitsToFloat(a.w);
  r.threshold = uintBitsToFloat(b.x);
  r.alias = b.y;
  return r;
}
LightRecord lightRecord(uint i) {
  uvec4 a = imageLoad(lightTexels, int(i * kTexelsPerLight));
  uvec4 b = imageLoad(lightTexels, int(i * kTexelsPerLight + 1u));
  uvec4 c = imageLoad(lightTexels, int(i * kTexelsPerLight + 2u));
  uvec4 d = imageLoad(lightTexels, int(i * kTexelsPerLight + 3u));
  LightRecord r;
  r.v0 = uintBitsToFloat(a.xyz);
  r.v1 = uintBitsToFloat(b.xyz);
  r.v2 = uintBitsToFloat(c.xyz);
  r.radiance = uintBitsToFloat(d.xyz);
  r.threshold = uintBitsToFloat(a.w);
  r.alias = b.w;
  r.probability = uintBitsToFloat(c.w);
  r.triangle = d.w;
  return r;
}

LightNode lightNode(uint i) {
  uvec4 a = imageLoad(lightNodeTexels, int(i * kTexelsPerLightNode));
  uvec4 b = imageLoad(lightNodeTexels, int(i * kTexelsPerLightNode + 1u));
  LightNode n;
  n.centre = uintBitsToFloat(a.xyz);
  n.radius = uintBitsToFloat(a.w);
  n.axis = lightAxis(b.x);
  n.cosSpread = uintBitsToFloat(b.y);
  n.power = uintBitsToFloat(b.z);
  n.below = b.w;
  return n;
}
LightNodePlace lightNodePlace(uint i) {
  uvec4 a = imageLoad(lightNodeTexels, int(i * kTexelsPerLightNode + 2u));
  return LightNodePlace(a.x, a.y);
}
vec3 lightGridLower() { return frame.lightGridLower.xyz; }
float lightGridCubesPerMetre() { return frame.lightGridLower.w; }
uint lightGridNumber(uint i) { return imageLoad(lightGridNumbers, int(i)).x; }

vec3 guideLower() { return frame.guideLower.xyz; }
float guideCubesPerMetre() { return frame.guideLower.w; }
uint guideGridEdge() { return frame.guideGridEdge; }
uint guideStart(uint cube) { return imageLoad(guideNumbers, int(cube)).x; }
AliasBin guideBin(uint histogram, uint bin) {
  return unpackBin(imageLoad(guideNumbers, int(histogram + bin)).x, kGuideBits);
}

uint lightCount() { return frame.lightCount; }
uint maxBounces() { return frame.maxBounces; }
uint rouletteAfter() { return frame.rouletteAfter; }
float survival() { return frame.survival; }
uint lightStrategy() { return frame.lightStrategy; }
uint lightSamples() { return frame.lightSamples; }
uint specularSamples() { return frame.specularSamples; }
uint splitDepth() { return frame.splitDepth; }
uint pathKinds() { return frame.pathKinds; }
uint deadHistories() { return frame.deadHistories; }
uint environmentWidth() { return frame.environmentWidth; }
uint environmentHeight() { return frame.environmentHeight; }
float environmentProbability() { return frame.environmentProbability; }
uint environmentLeaf() { return frame.environmentLeaf; }
vec4 filterShape() { return frame.filterShape; }
float filterEdge(uint i) { return frame.filterEdges[i >> 2u][i & 3u]; }
vec3 background() { return frame.background.xyz; }
bool tracesLights() { return frame.tracesLights != 0u; }
vec3 specularLower(uint i) { return frame.specularLower[i].xyz; }
vec3 specularUpper(uint i) { return frame.specularUpper[i].xyz; }
float splatUnits() { return frame.splatUnits; }
float splatSquareUnits() { return frame.splatSquareUnits; }
float sharedEyePdf_A() { return frame.sharedEyePdf_A; }
uint imageWidth() { return frame.width; }
uint imageHeight() { return frame.height; }
vec3 cameraForward() { return frame.forward.xyz; }
float cameraImageArea() { return frame.forward.w; }
vec3 cameraEye() { return frame.eye.xyz; }
vec3 cameraUpperLeft() { return frame.upperLeft.xyz; }
vec3 cameraRight() { return frame.right.xyz; }
vec3 cameraDown() { return frame.down.xyz; }
float inverseWidth() { return 1.0 / float(frame.width); }
float inverseHeight() { return 1.0 / float(frame.height); }

layout(set = 0, binding = kBindingPaths, std430) buffer PathBlock { uvec4 pathPlanes[]; };
layout(set = 0, binding = kBindingCounters, std430) buffer CounterBlock { Counters counters; };
layout(set = 0, binding = kBindingSlots, std430) buffer SlotBlock { uint slotLists[]; };
layout(set = 0, binding = kBindingFilm, std430) buffer FilmBlock { uint values[]; }
film[kFilmPlanes];
layout(set = 0, binding = kBindingReplicates, rgba32ui) uniform restrict uimageBuffer replicateTexels[3];
layout(set = 0, binding = kBindingSplats, r32ui) uniform restrict uimageBuffer splatTexels;
layout(set = 0, binding = kBindingKinds, std430) buffer KindBlock { float values[]; }
kinds[kKindCount];

layout(push_constant) uniform DispatchBlock { Dispatch job; };

// --- what a lane works on, for the library's memory of its own ---
uint g_slot = 0u;
uint g_pixel = 0u;
uint g_sample = 0u; // low half of its index
uint g_bounce = 0u;

vec3 filmColour(uint plane, uint pixel) {
  return vec3(uintBitsToFloat(film[plane].values[pixel]), uintBitsToFloat(film[plane + 1u].values[pixel]),
              uintBitsToFloat(film[plane + 2u].values[pixel]));
}

// Plane p of the saved path states.
uint statePlane(uint p, uint slot) { return p * job.slotCount + slot; }

void storeBranch(uint i, Branch b) {
  uint plane = kPathPlanes + i * kBranchPlanes;
  pathPlanes[statePlane(plane, g_slot)] = uvec4(floatBitsToUint(b.o), b.exclude);
  pathPlanes[statePlane(plane + 1u, g_slot)] = uvec4(floatBitsToUint(b.d), b.branch);
  pathPlanes[statePlane(plane + 2u, g_slot)] = uvec4(floatBitsToUint(b.beta), b.bounce);
}
Branch loadBranch(uint i) {
  uint plane = kPathPlanes + i * kBranchPlanes;
  uvec4 o = pathPlanes[statePlane(plane, g_slot)];
  uvec4 d = pathPlanes[statePlane(plane + 1u, g_slot)];
  uvec4 beta = pathPlanes[statePlane(plane + 2u, g_slot)];
  Branch b;
  b.o = uintBitsToFloat(o.xyz);
  b.exclude = o.w;
  b.d = uintBitsToFloat(d.xyz);
  b.branch = d.w;
  b.beta = uintBitsToFloat(beta.xyz);
  b.bounce = beta.w;
  return b;
}

// --- which pixel a lane works on ---

// Blocks are dealt out stripe by stripe, so that every range of them, a tile's or one thread's share of it, is
// spread over the image.
bool pixelOfSlot(uint slot, out uint x, out uint y) {
  uint striped = job.firstBlock + slot / kBlockPixels;
  uint block = (striped % kStripes) * frame.blocksPerStripe + striped / kStripes;
  x = (block % frame.blocksX) * kBlockEdge + columnInBlock(slot % kBlockPixels);
  y = (block / frame.blocksX) * kBlockEdge + rowInBlock(slot % kBlockPixels);
  return x < frame.width && y < frame.height && striped / kStripes < frame.blocksPerStripe;
}

#include "reuse_memory.glsl"

void addToSplat(uint number, WideCount n) {
  uint before = imageAtomicAdd(splatTexels, int(number), n.low);
  uint high = n.high + MUTATE(SplatCarryLost, before + n.low < before ? 1u : 0u, 0u);
  if (high != 0u) imageAtomicAdd(splatTexels, int(number + 1u), high);
}

// Plane p of a kind's image.
uint kindPlane(uint p, uint pixel) { return p * frame.width * frame.height + pixel; }

// Sums of the open group of samples, in registers while the lane works on its pixel: from and to storage buffers at
// every vertex they would cost more than the path. A buffer is chosen by constants, which every device can do.
vec3 g_kindSums[kKindCount];

#define VKPT_EACH_KIND(X)                                                                                    \
  X(kKindEmission) X(kKindDirect) X(kKindCaustic) X(kKindIndirect) X(kKindIndirectCaustic) X(kKindSpecular)
#define VKPT_ADD_TO_KIND(k) g_kindSums[k] += kind == k ? L : vec3(0.0);
#define VKPT_LOAD_KIND(k)                                                                                    \
  g_kindSums[k] = vec3(kinds[k].values[kindPlane(kKindOpen, g_pixel)],                                       \
                       kinds[k].values[kindPlane(kKindOpen + 1u, g_pixel)],                                  \
                       kinds[k].values[kindPlane(kKindOpen + 2u, g_pixel)]);
#define VKPT_STORE_KIND(k)                                                                                   \
  kinds[k].values[kindPlane(kKindOpen, g_pixel)] = g_kindSums[k].x;                                          \
  kinds[k].values[kindPlane(kKindOpen + 1u, g_pixel)] = g_kindSums[k].y;                                     \
  kinds[k].values[kindPlane(kKindOpen + 2u, g_pixel)] = g_kindSums[k].z;

void recordKind(uint kind, vec3 L) {
  if (!allFinite(L)) return; // the sample is a fault, counted where it ends
  VKPT_EACH_KIND(VKPT_ADD_TO_KIND)
}
void loadKinds() { VKPT_EACH_KIND(VKPT_LOAD_KIND) }
void storeKinds() { VKPT_EACH_KIND(VKPT_STORE_KIND) }

// --- what the library reports, per lane, summed up at the end of the dispatch ---
uint g_steps = 0u; // traversal steps of the subgroup so far
uint g_raysClosest = 0u;
uint g_raysShadow = 0u;
uint g_cutTraversals = 0u;
uint g_cappedPaths = 0u;
uint g_nonFinite = 0u;
uint g_invalidPdfs = 0u;

// The first faults of a dispatch are recorded, so that a path can be traced again: of a lane one, written at the end, since
// on lavapipe a store in a branch costs the same whether it is taken or not.
FaultRecord g_fault;
bool g_hasFault = false;
void recordFault(uint cause) {
  if (!g_hasFault) g_fault = FaultRecord(g_pixel, g_sample, g_bounce, cause);
  g_hasFault = true;
}
void storeFault() {
  if (g_hasFault) {
    uint i = atomicAdd(counters.faultRecords, 1u);
    if (i < kMaxFaultRecords) counters.records[i] = g_fault;
  }
}

void reportCut() {
  g_cutTraversals += 1u;
  recordFault(kFaultCutTraversal);
}
void reportTraversal(uint steps, bool cut) {
  g_steps += subgroupMaximum(steps);
  if (cut) reportCut();
}
// An iteration of one loop, where a step of a traversal counts for 1 + kNodesPerStep + kLeafTriangles.
void reportLightWalk(uint levels) {
  g_steps += subgroupMaximum(levels) / (1u + kNodesPerStep + kLeafTriangles) + 1u;
}
void reportClosestRay() { g_raysClosest += 1u; }
void reportShadowRay(bool traced) { g_raysShadow += traced ? 1u : 0u; }
void reportCappedPath() { g_cappedPaths += 1u; }
void reportNonFinite() {
  g_nonFinite += 1u;
  recordFault(kFaultNonFinite);
}
void reportInvalidPdf() {
  g_invalidPdfs += 1u;
  recordFault(kFaultInvalidPdf);
}

// carried: the lane's path has begun and is saved for the next dispatch.
void addCounters(bool carried) {
  uint carriedPaths = subgroupAdd(carried ? 1u : 0u);
  uint raysClosest = subgroupAdd(g_raysClosest);
  uint raysShadow = subgroupAdd(g_raysShadow);
  uint cappedPaths = subgroupAdd(g_cappedPaths);
  uint nonFinite = subgroupAdd(g_nonFinite);
  uint cutTraversals = subgroupAdd(g_cutTraversals);
  uint invalidPdfs = subgroupAdd(g_invalidPdfs);
  if (subgroupElect()) {
    atomicAdd(counters.carriedPaths, carriedPaths);
    atomicAdd(counters.raysClosest, raysClosest);
    atomicAdd(counters.raysShadow, raysShadow);
    atomicAdd(counters.cappedPaths, cappedPaths);
    atomicAdd(counters.nonFinite, nonFinite);
    atomicAdd(counters.cutTraversal, cutTraversals);
    atomicAdd(counters.invalidPdf, invalidPdfs);
  }
  storeFault();
}
// The same of lanes that have traced nothing but a shadow ray.
void addShadowRays() {
  uint raysShadow = subgroupAdd(g_raysShadow);
  if (subgroupElect()) atomicAdd(counters.raysShadow, raysShadow);
  if (g_cutTraversals > 0u) atomicAdd(counters.cutTraversal, g_cutTraversals);
  storeFault();
}
