#pragma once
// Both sides in turns on the same work, by Google Benchmark.

#include "bench_scene.h"
#include "measurements.h"

#include <functional>
#include <string>

namespace vkpt::bench {

struct Turns {
  int rounds = 5;
  std::uint64_t frames = 16; ///< samples a pixel and turn
};

/// Both throw where the two sides don't compute the same.
Comparison racePaths(const Turns& turns, SceneBench& scene);
Comparison raceRays(const Turns& turns, SceneBench& scene, SceneBench::RayBench& rays);

} // namespace vkpt::bench
