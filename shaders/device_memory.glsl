// The device's memory behind the library's accessors: texel buffers, since lavapipe loads them 2-3 times faster
// than storage buffers. A program for another device changes this file alone.
// Written as rgba32ui: a denormal float that carries an integer could be flushed to 0.

#define VKPT_DECLARE_EFFECT(id, Name, name, what) layout(constant_id = id) const bool kEffect##Name = true;
VKPT_EFFECTS(VKPT_DECLARE_EFFECT)
layout(constant_id = 64) const uint kStackDepth = kMaxStackDepth; // kConstantStackDepth
layout(constant_id = 65) const uint kRouletteMode = 1u; // kConstantRouletteMode

layout(set = 0, binding = kBindingFrame, std140) uniform FrameBlock { FrameConstants frame; };

layout(set = 0, binding = kBindingNodes, rgba32ui) uniform readonly restrict uimageBuffer nodeTexels;
layout(set = 0, binding = kBindingTriangles, rgba32ui) uniform readonly restrict uimageBuffer triangleTexels;
layout(set = 0, binding = kBindingNormals, rgba32ui) uniform readonly restrict uimageBuffer normalTexels;
layout(set = 0, binding = kBindingMaterials, rgba32ui) uniform readonly restrict uimageBuffer materialTexels;
layout(set = 0, binding = kBindingLights, rgba32ui) uniform readonly restrict uimageBuffer lightTexels;

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
  return r;
}
vec3 triangleNormal(uint i, uint corner) {
  return uintBitsToFloat(imageLoad(normalTexels, int(i * kTexelsPerTriangle + corner)).xyz);
}
Material material(uint i) {
  uvec4 a = imageLoad(materialTexels, int(i * kTexelsPerMaterial));
  uvec4 b = imageLoad(materialTexels, int(i * kTexelsPerMaterial + 1u));
  uvec4 c = imageLoad(materialTexels, int(i * kTexelsPerMaterial + 2u));
  uvec4 d = imageLoad(materialTexels, int(i * kTexelsPerMaterial + 3u));
  Material m;
  m.bsdf = a.w;
  m.reflectance = uintBitsToFloat(a.xyz);
  m.emission = uintBitsToFloat(b.xyz);
  m.ior = uintBitsToFloat(b.w);
  m.eta = uintBitsToFloat(c.xyz);
  m.k = uintBitsToFloat(d.xyz);
  return m;
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

uint lightCount() { return frame.lightCount; }
uint maxBounces() { return frame.maxBounces; }
uint rouletteAfter() { return frame.rouletteAfter; }
vec3 background() { return frame.background.xyz; }
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

layout(push_constant) uniform DispatchBlock { Dispatch job; };

// --- what the library reports, per lane, summed up at the end of the dispatch ---
uint g_steps = 0u; // traversal steps of the subgroup so far
uint g_raysClosest = 0u;
uint g_raysShadow = 0u;
uint g_cutTraversals = 0u;
uint g_cappedPaths = 0u;
uint g_nonFinite = 0u;

void reportTraversal(uint steps, bool cut) {
  g_steps += subgroupMaximum(steps);
  g_cutTraversals += cut ? 1u : 0u;
}
void reportClosestRay() { g_raysClosest += 1u; }
void reportShadowRay(bool traced) { g_raysShadow += traced ? 1u : 0u; }
void reportCappedPath() { g_cappedPaths += 1u; }
void reportNonFinite() { g_nonFinite += 1u; }

// carried: the lane's path has begun and is saved for the next dispatch.
void addCounters(bool carried) {
  uint carriedPaths = subgroupAdd(carried ? 1u : 0u);
  uint raysClosest = subgroupAdd(g_raysClosest);
  uint raysShadow = subgroupAdd(g_raysShadow);
  uint cappedPaths = subgroupAdd(g_cappedPaths);
  uint nonFinite = subgroupAdd(g_nonFinite);
  uint cutTraversals = subgroupAdd(g_cutTraversals);
  if (subgroupElect()) {
    atomicAdd(counters.carriedPaths, carriedPaths);
    atomicAdd(counters.raysClosest, raysClosest);
    atomicAdd(counters.raysShadow, raysShadow);
    atomicAdd(counters.cappedPaths, cappedPaths);
    atomicAdd(counters.nonFinite, nonFinite);
    atomicAdd(counters.cutTraversal, cutTraversals);
  }
}

// --- which pixel a lane works on ---

// Blocks are dealt out stripe by stripe, so that every range of them, a tile's or one thread's share of it, is
// spread over the image. Within a block pixels lie in Morton order: a subgroup of 8 is a tile of 4 x 2.
bool pixelOfSlot(uint slot, out uint x, out uint y) {
  uint striped = job.firstBlock + slot / kBlockPixels;
  uint block = (striped % kStripes) * frame.blocksPerStripe + striped / kStripes;
  uint lane = slot % kBlockPixels;
  uint mx = (lane & 1u) | ((lane >> 1u) & 2u) | ((lane >> 2u) & 4u);
  uint my = ((lane >> 1u) & 1u) | ((lane >> 2u) & 2u) | ((lane >> 3u) & 4u);
  x = (block % frame.blocksX) * kBlockEdge + mx;
  y = (block / frame.blocksX) * kBlockEdge + my;
  return x < frame.width && y < frame.height && striped / kStripes < frame.blocksPerStripe;
}
