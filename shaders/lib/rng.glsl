// Counter-based random numbers: a block of four is a hash of (pixel, sample, block, seed), so that no order of
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
Float toUnit(uint bits) { return Float(bits >> 8u) * 5.9604644775390625e-8; }

// Blocks of random numbers a path uses: 0 the camera; 1 + 2 * bounce lights, 2 + 2 * bounce BSDF and roulette.
CONSTANT uint kBlockCamera = 0u;
uint blockLight(uint bounce) { return MUTATE(LightBlockReused, 1u, 2u) + 2u * bounce; }
uint blockBsdf(uint bounce) { return MUTATE(NextLightBlockReused, 2u, 3u) + 2u * bounce; }

UVec4 randomBlock(uint pixel, uint sampleLow, uint block, uint key) {
  return pcg4d(UVec4(pixel, MUTATE(SampleIgnored, sampleLow, 0u), block, key));
}
