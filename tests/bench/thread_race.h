#pragma once
// Two threads of lavapipe against one: a process each, since the driver reads their number when it is loaded.

#include "measurements.h"

#include "core/error.h"

#include <cstdint>
#include <string>

namespace vkpt::bench {

/// What a process of its own renders.
struct ChildJob {
  std::string scene;
  fs::path mesh;
  int size;
  std::uint64_t frames;
};

Comparison raceThreads(const ChildJob& job, int rounds);

/// In that process: renders with as many threads as the environment says and prints the rates.
void runChild(const ChildJob& job);

} // namespace vkpt::bench
