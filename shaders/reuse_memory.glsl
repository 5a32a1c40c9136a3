// The device's memory of paths that pixels share, behind the accessors of lib/reuse.glsl: part of device_memory.glsl.

layout(set = 0, binding = kBindingReuse, rgba32ui) uniform restrict uimageBuffer reuseTexels;
layout(set = 0, binding = kBindingConnections, r32ui) uniform restrict uimageBuffer connectionTexels;

#ifdef VKPT_LEAVES_VERTICES // first_vertices.comp
bool leavesVertices() { return true; }
#else
bool leavesVertices() { return false; }
#endif
int sharedTexel(uint slot, uint sampleLow, uint i) {
  uint texels = kTexelsPerSharedPath + kTexelsPerBegunPath + (kEffectLightTree ? kVertexPlanes : 0u);
  return int(((sampleLow - job.firstSample) * texels + i) * job.slotCount + slot);
}
int connectionTexel(uint slot, uint sampleLow, uint member) {
  return int((member * job.sampleCount + sampleLow - job.firstSample) * job.slotCount + slot);
}
void storeShared(uint slot, uint sampleLow, uint i, vec3 v, uint w) {
  imageStore(reuseTexels, sharedTexel(slot, sampleLow, i), uvec4(floatBitsToUint(v), w));
}
uvec4 loadShared(uint slot, uint sampleLow, uint i) { return imageLoad(reuseTexels, sharedTexel(slot, sampleLow, i)); }

// Of the lane's path, until all that it leaves is stored together: a store in a branch costs as much as one outside.
FirstVertex g_firstVertex;
SecondVertex g_secondVertex;
vec3 g_ownLight;
void keepFirstVertex(FirstVertex a) { g_firstVertex = a; }
void keepSecondVertex(SecondVertex b, vec3 own) {
  g_secondVertex = b;
  g_ownLight = own;
}
void storeVertices(uint slot, uint sampleLow) {
  storeShared(slot, sampleLow, 0u, g_firstVertex.o, floatBitsToUint(g_firstVertex.ng.x));
  storeShared(slot, sampleLow, 1u, g_firstVertex.n, floatBitsToUint(g_firstVertex.ng.y));
  storeShared(slot, sampleLow, 2u, g_firstVertex.weight, floatBitsToUint(g_firstVertex.ng.z));
  storeShared(slot, sampleLow, 3u, g_secondVertex.end, g_secondVertex.triangle);
  storeShared(slot, sampleLow, 4u, g_secondVertex.ng, g_secondVertex.pixel);
}
FirstVertex firstVertex(uint slot, uint sampleLow) {
  uvec4 o = loadShared(slot, sampleLow, 0u);
  uvec4 n = loadShared(slot, sampleLow, 1u);
  uvec4 weight = loadShared(slot, sampleLow, 2u);
  FirstVertex a;
  a.o = uintBitsToFloat(o.xyz);
  a.n = uintBitsToFloat(n.xyz);
  a.ng = uintBitsToFloat(uvec3(o.w, n.w, weight.w));
  a.weight = uintBitsToFloat(weight.xyz);
  return a;
}
SecondVertex secondVertex(uint slot, uint sampleLow) {
  uvec4 end = loadShared(slot, sampleLow, 3u);
  uvec4 ng = loadShared(slot, sampleLow, 4u);
  SecondVertex b;
  b.end = uintBitsToFloat(end.xyz);
  b.triangle = end.w;
  b.ng = uintBitsToFloat(ng.xyz);
  b.pixel = ng.w;
  return b;
}
// Of a sample whose path has ended; one store for either.
void storeLight(uint slot, uint sampleLow, bool isShared, vec3 L) {
  storeShared(slot, sampleLow, isShared ? 5u : 6u, L, 0u);
}
vec3 ownLight(uint slot, uint sampleLow) { return uintBitsToFloat(loadShared(slot, sampleLow, 6u).xyz); }
void storeOwnLight(uint slot, uint sampleLow, vec3 L) { storeLight(slot, sampleLow, false, L); }
SharedLight sharedLight(uint slot, uint sampleLow) {
  uvec4 a = loadShared(slot, sampleLow, 5u);
  return SharedLight(uintBitsToFloat(a.xyz), uintBitsToFloat(a.w));
}
void storeBalance(uint slot, uint sampleLow, float pdf_A) {
  storeShared(slot, sampleLow, 5u, sharedLight(slot, sampleLow).L, floatBitsToUint(pdf_A));
}
void storeConnection(uint slot, uint sampleLow, uint member, float pdf_A) {
  imageStore(connectionTexels, connectionTexel(slot, sampleLow, member), uvec4(floatBitsToUint(pdf_A)));
}
float connection(uint slot, uint sampleLow, uint member) {
  return uintBitsToFloat(imageLoad(connectionTexels, connectionTexel(slot, sampleLow, member)).x);
}
