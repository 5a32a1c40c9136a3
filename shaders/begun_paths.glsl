// What path.comp and first_vertices.comp know of a path: its state between dispatches, and that of paths that are begun
// in one and gone on with in the next, a place for every slot and sample.

uint randomKey() { return frame.seed ^ MUTATE(SampleHighIgnored, job.firstSampleHigh * 0x9E3779B9u, 0u); }

// A path between dispatches: four texels, of which the last has 16 bits to spare, the vertex before behind them where
// there is a light tree, and two numbers that the caller finds a place for.
struct PathTexels {
  uvec4 origin;
  uvec4 direction;
  uvec4 throughput;
  uvec4 light;
};

PathTexels packPath(Path path, uint spare) {
  uint flags = (path.emit ? 1u : 0u) | (path.waiting << 1u) | (path.history << 6u) | (path.repeat << 10u) |
               (path.repeats > 1u ? 1u << 14u : 0u) | (spare << 16u);
  PathTexels t;
  t.origin = uvec4(floatBitsToUint(path.ray.o), floatBitsToUint(path.otherPdf_A));
  t.direction = uvec4(floatBitsToUint(path.ray.d), path.ray.exclude);
  t.throughput = uvec4(floatBitsToUint(path.beta), path.bounce | (path.branch << 14u) | (path.reuse << 30u));
  t.light = uvec4(floatBitsToUint(path.L), flags);
  return t;
}

void unpackPath(inout Path path, PathTexels t) {
  path.ray.o = uintBitsToFloat(t.origin.xyz);
  path.otherPdf_A = uintBitsToFloat(t.origin.w);
  path.ray.d = uintBitsToFloat(t.direction.xyz);
  path.ray.exclude = t.direction.w;
  path.beta = uintBitsToFloat(t.throughput.xyz);
  path.bounce = t.throughput.w & 0x3FFFu;
  path.branch = (t.throughput.w >> 14u) & 0xFFFFu;
  path.reuse = t.throughput.w >> 30u;
  path.L = uintBitsToFloat(t.light.xyz);
  path.emit = MUTATE(CarriedEmitLost, (t.light.w & 1u) != 0u, true);
  path.waiting = MUTATE(CarriedBranchLost, (t.light.w >> 1u) & 31u, 0u);
  path.history = MUTATE(CarriedHistoryLost, (t.light.w >> 6u) & 15u, kHistoryEye);
  path.repeat = MUTATE(CarriedRepeatLost, (t.light.w >> 10u) & 15u, 0u);
  path.repeats = ((t.light.w >> 14u) & 1u) != 0u ? specularSamples() : 1u;
}
uint spareBits(PathTexels t) { return t.light.w >> 16u; }

// L as it counts: 0, and a fault, where it is not finite.
vec3 countedLight(vec3 L) {
  bool finite = allFinite(L);
  if (!finite && MUTATE(FaultsHidden, true, false)) reportNonFinite();
  return finite ? L : vec3(0.0);
}

// Of a sample whose path has ended. L: what it has gathered, since its second vertex if it shares that.
void storePathsLight(Path path, vec3 L) {
  bool isShared = path.reuse == kReuseShared;
  storeLight(g_slot, path.sampleLow, isShared, isShared ? L : L * path.sampleWeight);
}

void storeBegun(Path path, uint i, uvec4 texel) {
  imageStore(reuseTexels, sharedTexel(g_slot, path.sampleLow, kTexelsPerSharedPath + i), texel);
}

void storeBegunPath(Path path, bool goesOn) {
  PathTexels t = packPath(path, goesOn ? 1u : 0u);
  storeBegun(path, 0u, t.origin);
  storeBegun(path, 1u, t.direction);
  storeBegun(path, 2u, t.throughput);
  storeBegun(path, 3u, t.light);
  storeBegun(path, 4u, uvec4(floatBitsToUint(path.pdf_w), floatBitsToUint(path.sampleWeight), 0u, 0u));
  if (kEffectLightTree) {
    storeBegun(path, 5u, uvec4(floatBitsToUint(path.from), path.fromTable));
    storeBegun(path, 6u, uvec4(floatBitsToUint(path.fromNormal), 0u));
  }
}

uvec4 loadBegun(uint slot, uint sampleLow, uint i) { return loadShared(slot, sampleLow, kTexelsPerSharedPath + i); }

PathTexels begunTexels(uint slot, uint sampleLow) {
  return PathTexels(loadBegun(slot, sampleLow, 0u), loadBegun(slot, sampleLow, 1u), loadBegun(slot, sampleLow, 2u),
                    loadBegun(slot, sampleLow, 3u));
}

bool begunPathGoesOn(uint slot, uint sampleLow) { return spareBits(begunTexels(slot, sampleLow)) != 0u; }

Path begunPath(uint slot, uint pixel, uint sampleLow) {
  Path path;
  unpackPath(path, begunTexels(slot, sampleLow));
  uvec4 rest = loadBegun(slot, sampleLow, 4u);
  path.pdf_w = uintBitsToFloat(rest.x);
  path.sampleWeight = uintBitsToFloat(rest.y);
  path.from = path.ray.o;
  path.fromNormal = vec3(0.0);
  path.fromTable = 0u;
  if (kEffectLightTree) {
    uvec4 from = loadBegun(slot, sampleLow, 5u);
    path.from = uintBitsToFloat(from.xyz);
    path.fromTable = from.w;
    path.fromNormal = uintBitsToFloat(loadBegun(slot, sampleLow, 6u).xyz);
  }
  path.pixel = pixel;
  path.sampleLow = sampleLow;
  path.key = randomKey();
  return path;
}
