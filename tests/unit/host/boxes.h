#pragma once
// Both Cornell boxes, ready for the host programs.

#include "host/reference.h"

#include <array>
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

/// How many samples part, measured over six seeds of 65 536 samples each; the tests leave room for chance
/// alone. Float against float only sines, square roots and the order of operations differ: an ulp or two.
/// Against double the origins of rays differ too, offset by 16 ulp of the coordinates (2e-5 here): about that
/// share of the box's extent, times its edges. Spheres magnify what is different at every bounce.
struct BoxParity {
  const char* box;
  double partedInFloat;  ///< per sample, device against float
  double partedInDouble; ///< per sample, either against double
};
inline constexpr auto kBoxParities = std::to_array<BoxParity>({
    {"blocks", 0.5 / 65536, 6.0 / 65536},
    {"spheres", 5.0 / 65536, 34.0 / 65536},
});

} // namespace vkpt::test
