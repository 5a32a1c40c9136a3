#pragma once
// Rays recorded from paths, in the layout that trace.comp reads: two texels each.

#include <array>
#include <cstdint>
#include <vector>

namespace vkpt::bench {

struct RecordedRay {
  std::array<float, 3> o;
  float tMax; ///< shadow rays: length
  std::array<float, 3> d;
  std::uint32_t exclude; ///< the triangle the ray leaves; shadow rays: the light they lead to
};
static_assert(sizeof(RecordedRay) == 32);

/// One path a pixel, in the order in which the device's lanes take pixels.
struct RaySet {
  std::vector<RecordedRay> primary; ///< from the camera
  std::vector<RecordedRay> bounce;  ///< from the first vertex
  std::vector<RecordedRay> shadow;  ///< from the first vertex to a light
};

} // namespace vkpt::bench
