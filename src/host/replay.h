#pragma once
// One path again, vertex by vertex, in float and in double: what a fault, or a pixel in doubt, is made of.

#include "host/reference.h"

#include <cstdint>
#include <vector>

namespace vkpt {

/// One call of Li(): a ray, what it met, and what the path had after it.
struct ReplayStep {
  std::uint32_t bounce = 0;
  std::uint32_t branch = 0; ///< of a split path
  Vec3d origin{0.0};        ///< of the ray, in local coordinates
  Vec3d direction{0.0};
  bool hit = false;
  double distance = 0.0;
  std::uint32_t triangle = 0; ///< in input order
  bool front = false;         ///< met from the side its normal points to
  Vec3d throughput{0.0};      ///< with which the ray set out
  Vec3d gathered{0.0};        ///< radiance that this step added
  bool goesOn = false;
};

struct Replay {
  std::vector<ReplayStep> steps;
  Vec3d value{0.0}; ///< of the sample, the filter's weight included
};

/// Sample number `sample` of pixel (x, y): the same random numbers as on the device.
Replay replay32(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                const HostSettings& settings, int x, int y, std::uint64_t sample);
Replay replay64(const PackedScene& scene, const Scene& source, const EffectSet& effects,
                const HostSettings& settings, int x, int y, std::uint64_t sample);

} // namespace vkpt
