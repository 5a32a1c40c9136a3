#pragma once
// What a pixel, or a point of the scene, is made of.

#include "app/view/stage.h"

#include <array>
#include <optional>

namespace vkpt {

struct PixelReport {
  Vec2i pixel{0};
  std::uint64_t samples = 0;                 ///< in the film
  Vec3d mean{0.0};                           ///< of the film, W m^-2 sr^-1
  Vec3d standardError{0.0};                  ///< of it, 0 where samples < 2
  std::array<Vec3d, kPathKindCount> kinds{}; ///< mean of each kind over the first `kindSamples` samples
  std::uint64_t kindSamples = 0;             ///< 0: the shader traces no paths
};

/// From the film, and for the kinds by the same estimator on the host: the film holds no kinds.
PixelReport reportPixel(const Stage& stage, const ViewSettings& settings, Vec2i pixel);

/// Where the ray through a pixel's middle region first meets the scene, in world coordinates.
std::optional<Vec3d> pointAt(const Stage& stage, Vec2i pixel);

} // namespace vkpt
