#pragma once
// Both Cornell boxes, ready for the host programs.

#include "host/reference.h"

#include <vector>

namespace vkpt::test {

struct CornellScene {
  std::string name;
  Scene scene;
  EffectSet effects;
  PackedScene packed;
  HostSettings settings;
};
/// "blocks" and "spheres", as vkpt renders them by default but for the size and the seed.
CornellScene cornellBox(const std::string& name, int size, std::uint32_t seed);

} // namespace vkpt::test
