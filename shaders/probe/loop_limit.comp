#version 460
// Counts 1000 x 100 nested iterations. Stops after kBudget of them and leaves its state for the next dispatch;
// a budget that is never met makes it the naive loop.

layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kBudget = 0xFFFFFFFFu;

layout(set = 0, binding = 0, std430) readonly buffer BeforeBlock { uvec4 before[]; }; // outer, inner, count, -
layout(set = 0, binding = 1, std430) writeonly buffer AfterBlock { uvec4 after[]; };

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint i = before[lane].x;
  uint j = before[lane].y;
  uint count = before[lane].z;
  uint steps = 0u;
  if (i < 1000u) {
    do {
      do {
        count += 1u;
        j += 1u;
        steps += 1u;
      } while (j < 100u && steps < kBudget);
      i += j == 100u ? 1u : 0u;
      j = j == 100u ? 0u : j;
    } while (i < 1000u && steps < kBudget);
  }
  after[lane] = uvec4(i, j, count, 0u);
}
