// What path.comp and first_vertices.comp know of a path: its state between dispatches, and that of paths that are begun
// in one and gone on with in the next, a place for every slot and sample.

uint randomKey() { return frame.seed ^ MUTATE(SampleHighIgnored, job.firstSampleHigh * 0x9E3779B9u, 0u); }

// In 16 bits.
uint pathFlags(Path path) {
  return (path.emit ? 1u : 0u) | (path.waiting << 1u) | (path.history << 6u) | (path.repeat << 10u) |
         (path.repeats > 1u ? 1u << 14u : 0u);
}
void setPathFlags(inout Path path, uint flags) {
  path.emit = MUTATE(CarriedEmitLost, (flags & 1u) != 0u, true);
  path.waiting = MUTATE(CarriedBranchLost, (flags >> 1u) & 31u, 0u);
  path.history = MUTATE(CarriedHistoryLost, (flags >> 6u) & 15u, kHistoryEye);
  path.repeat = MUTATE(CarriedRepeatLost, (flags >> 10u) & 15u, 0u);
  path.repeats = ((flags >> 14u) & 1u) != 0u ? specularSamples() : 1u;
}

// Of a sample whose path has ended. L: what it has gathered, since its second vertex if it shares that.
void storePathsLight(Path path, vec3 L) {
  bool isShared = path.reuse == kReuseShared;
  storeLight(g_slot, path.sampleLow, isShared, isShared ? L : L * path.sampleWeight);
}

void storeBegun(Path path, uint i, vec3 v, uint w) {
  storeShared(g_slot, path.sampleLow, kTexelsPerSharedPath + i, v, w);
}

void storeBegunPath(Path path, bool goesOn) {
  storeBegun(path, 0u, path.ray.o, floatBitsToUint(path.otherPdf_A));
  storeBegun(path, 1u, path.ray.d, path.ray.exclude);
  storeBegun(path, 2u, path.beta, path.bounce | (path.branch << 14u) | (path.reuse << 30u));
  storeBegun(path, 3u, path.L, pathFlags(path) | (goesOn ? 1u << 16u : 0u));
  storeBegun(path, 4u, vec3(path.pdf_w, path.sampleWeight, 0.0), 0u);
  if (kEffectLightTree) {
    storeBegun(path, 5u, path.from, 0u);
    storeBegun(path, 6u, path.fromNormal, 0u);
  }
}

uvec4 loadBegun(uint slot, uint sampleLow, uint i) { return loadShared(slot, sampleLow, kTexelsPerSharedPath + i); }

bool begunPathGoesOn(uint slot, uint sampleLow) { return (loadBegun(slot, sampleLow, 3u).w >> 16u) != 0u; }

Path begunPath(uint slot, uint pixel, uint sampleLow) {
  uvec4 a = loadBegun(slot, sampleLow, 0u);
  uvec4 b = loadBegun(slot, sampleLow, 1u);
  uvec4 c = loadBegun(slot, sampleLow, 2u);
  uvec4 d = loadBegun(slot, sampleLow, 3u);
  uvec4 e = loadBegun(slot, sampleLow, 4u);
  Path path;
  path.ray.o = uintBitsToFloat(a.xyz);
  path.otherPdf_A = uintBitsToFloat(a.w);
  path.ray.d = uintBitsToFloat(b.xyz);
  path.ray.exclude = b.w;
  path.beta = uintBitsToFloat(c.xyz);
  path.bounce = c.w & 0x3FFFu;
  path.branch = (c.w >> 14u) & 0xFFFFu;
  path.reuse = c.w >> 30u;
  path.L = uintBitsToFloat(d.xyz);
  setPathFlags(path, d.w);
  path.pdf_w = uintBitsToFloat(e.x);
  path.sampleWeight = uintBitsToFloat(e.y);
  path.from = path.ray.o;
  path.fromNormal = vec3(0.0);
  if (kEffectLightTree) {
    path.from = uintBitsToFloat(loadBegun(slot, sampleLow, 5u).xyz);
    path.fromNormal = uintBitsToFloat(loadBegun(slot, sampleLow, 6u).xyz);
  }
  path.pixel = pixel;
  path.sampleLow = sampleLow;
  path.key = randomKey();
  return path;
}
