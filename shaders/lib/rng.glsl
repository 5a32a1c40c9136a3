// Random bits and numbers.

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
