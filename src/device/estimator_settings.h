#pragma once
// How light transport is estimated: the options that decide what the kernel computes.

#include "scene/scene.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace vkpt {

enum class RouletteMode : std::uint32_t {
  Albedo = 0,     ///< survive with the surface's mean reflectance
  Throughput = 1, ///< survive with the path's throughput
};

inline constexpr std::uint32_t kUnlimitedBounces = std::numeric_limits<std::uint32_t>::max();

struct EstimatorSettings {
  LightStrategy light = LightStrategy::Nee;
  std::uint32_t maxBounces = kUnlimitedBounces; ///< 0: emitted light only, 1: + direct light, ...
  RouletteMode roulette = RouletteMode::Throughput;
  std::optional<std::uint32_t> rouletteAfter; ///< first bounce after whose direct light a path may end

  [[nodiscard]] std::uint32_t effectiveRouletteAfter() const {
    return rouletteAfter.value_or(roulette == RouletteMode::Albedo ? 1U : 3U);
  }
};

} // namespace vkpt
