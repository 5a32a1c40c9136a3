// Counter-based random numbers: a block of four is a hash of (pixel, sample, block, key), so that no order of
// work, batch, tile or effect changes them.

// pcg4d: Jarzynski and Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3).
UVec4 pcg4d(UVec4 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  v.x ^= v.x >> 16u;
  v.y ^= v.y >> 16u;
  v.z ^= v.z >> 16u;
  v.w ^= v.w >> 16u;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  return v;
}

// 24 bits: in [0, 1), never 1.
Float toUnit(uint bits) {
  return MUTATE(UnitMayBeOne, Float(bits >> 8u) * 5.9604644775390625e-8, Float(bits) * 2.3283064365386963e-10);
}

// Blocks of random numbers a path uses, by bounce: the BSDF and roulette; two for each light sample. The camera's
// stands alone. Branches of a split path differ in their key.
CONSTANT uint kBlockCamera = 0x80000000u;
CONSTANT uint kBlockStride = 0x10000u; // above any bounce
uint blockBsdf(uint bounce) { return MUTATE(NextLightBlockReused, bounce, bounce + 1u + kBlockStride); }
uint blockLight(uint bounce, uint i) {
  return bounce + MUTATE(LightBlockReused, 1u + 2u * i, 2u * i) * kBlockStride;
}
uint blockLightPoint(uint bounce, uint i) { return bounce + (2u + 2u * i) * kBlockStride; }

UVec4 randomBlock(uint pixel, uint sampleLow, uint block, uint key) {
  if (MUTATE(PixelKeyIsSum, false, true)) return pcg4d(UVec4(pixel + sampleLow, 0u, block, key));
  return pcg4d(UVec4(pixel, MUTATE(SampleIgnored, sampleLow, 0u), block, key));
}
uint branchKey(uint key, uint branch) { return key ^ (MUTATE(BranchKeyShared, branch, 0u) * 0x85EBCA6Bu); }
