#version 460
// A value loaded inside a loop that lanes leave one by one, kept in two ways: read after the loop, and stored
// inside it by the lane that is about to leave.

layout(local_size_x = 64) in;

layout(set = 0, binding = 0, std430) readonly buffer DataBlock { uint data[]; }; // 64 rows of 64
layout(set = 0, binding = 1, std430) writeonly buffer ResultBlock { uvec2 results[]; }; // after, inside

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint i = 0u;
  uint value;
  while (true) {
    value = data[i * 64u + lane];
    bool done = i >= lane;
    if (done) results[lane].y = value;
    if (done) break;
    i += 1u;
  }
  results[lane].x = value;
}
