// A path's random numbers, by counter: a block of four is a function of (pixel, sample, block, key), so that no order
// of work, batch, tile or effect changes them. Either a hash, or two points of Sobol's sequence.

// Blocks of random numbers a path uses, by bounce: the BSDF and roulette; two for each light sample. The camera's
// stands alone. Branches of a split path differ in their key.
CONSTANT uint kBlockCamera = 0x80000000u;
CONSTANT uint kBlockStride = 0x10000u; // above any bounce
uint blockBsdf(uint bounce) { return MUTATE(NextLightBlockReused, bounce, bounce + 1u + kBlockStride); }
uint blockLight(uint bounce, uint i) {
  return bounce + MUTATE(LightBlockReused, 1u + 2u * i, 2u * i) * kBlockStride;
}
uint blockLightPoint(uint bounce, uint i) { return bounce + (2u + 2u * i) * kBlockStride; }

// A hash whose every bit depends on itself and on lower bits alone. On bits in reverse it is a nested uniform scrambling
// (Owen 1995) in base 2: Laine and Karras 2011, "Stratified Sampling for Stochastic Transparency"; constants by
// Vegdahl 2021.
uint laineKarras(uint v, uint seed) {
  v ^= v * 0x3D20ADEAu;
  v += seed;
  v *= (seed >> 16u) | 1u;
  v ^= v * 0x05526C56u;
  v ^= v * 0x53A22864u;
  return v;
}

// Bit k becomes the sum modulo 2 of binomial(j, k) times bit j: with the bits in reverse, the second dimension of
// Sobol's sequence.
uint pascalBits(uint v) {
  v ^= (v >> 1u) & 0x55555555u;
  v ^= (v >> 2u) & 0x33333333u;
  v ^= (v >> 4u) & 0x0F0F0F0Fu;
  v ^= (v >> 8u) & 0x00FF00FFu;
  v ^= (v >> 16u) & 0x0000FFFFu;
  return v;
}

// Which replicate a sample belongs to, and its number there.
uint replicateOf(uint sampleLow) {
  return MUTATE(ReplicatesAlike, (sampleLow / kSamplesPerGroup) % kReplicates, 0u);
}
uint numberInReplicate(uint sampleLow) {
  return sampleLow / (kSamplesPerGroup * kReplicates) * kSamplesPerGroup + sampleLow % kSamplesPerGroup;
}

// Two points of the (0, 2)-sequence, each of an order and a scrambling of its own: Burley 2020, "Practical Hash-based
// Owen Scrambling", JCGT 9(4). What is stratified together is (x, y) and (z, w).
UVec4 sobolBlock(uint pixel, uint sampleLow, uint block, uint key) {
  UVec4 seeds = pcg4d(UVec4(pixel, replicateOf(sampleLow), block, key));
  uint number = reverseBits(numberInReplicate(sampleLow));
  uint first = reverseBits(laineKarras(number, seeds.x ^ seeds.y));
  uint second = reverseBits(laineKarras(number, seeds.z ^ seeds.w));
  UVec4 points = UVec4(first, pascalBits(first), second, pascalBits(second));
  return UVec4(reverseBits(laineKarras(points.x, seeds.x)), reverseBits(laineKarras(points.y, seeds.y)),
               reverseBits(laineKarras(points.z, seeds.z)), reverseBits(laineKarras(points.w, seeds.w)));
}

UVec4 independentBlock(uint pixel, uint sampleLow, uint block, uint key) {
  if (MUTATE(PixelKeyIsSum, false, true)) return pcg4d(UVec4(pixel + sampleLow, 0u, block, key));
  return pcg4d(UVec4(pixel, MUTATE(SampleIgnored, sampleLow, 0u), block, key));
}

UVec4 randomBlock(uint pixel, uint sampleLow, uint block, uint key) {
  if (kSampler == kSamplerSobol) return sobolBlock(pixel, sampleLow, block, key);
  return independentBlock(pixel, sampleLow, block, key);
}

uint branchKey(uint key, uint branch) { return key ^ (MUTATE(BranchKeyShared, branch, 0u) * 0x85EBCA6Bu); }
