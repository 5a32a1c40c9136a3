#pragma once
// How light transport is estimated: the options that decide what the kernel computes.

#include "scene/scene.h"
#include "shared/structs.h"

#include <cstdint>
#include <limits>
#include <optional>

namespace vkpt {

enum class RouletteMode : std::uint32_t {
  Albedo = 0,     ///< survive with the surface's mean reflectance
  Throughput = 1, ///< survive with the path's throughput
  Constant = 2,   ///< end with a constant probability
};

/// Where random numbers come from.
enum class Sampler : std::uint32_t {
  Independent = shared::kSamplerIndependent,
  Sobol = shared::kSamplerSobol, ///< Owen-scrambled, in shared::kReplicates replicates
};

/// Whether paths from the lights bring caustics to the image: shaders/lib/light_path.glsl.
enum class LightTracing : std::uint32_t {
  Auto, ///< where the scene and the other settings have them
  On,   ///< an error where the other settings or the scene's materials don't allow it
  Off,
};

/// Whether directions behind specular surfaces are drawn from where light was seen to come from before the
/// render: shaders/lib/guide.glsl.
enum class Guiding : std::uint32_t {
  Auto, ///< where paths from the lights are traced
  Off,
};

inline constexpr std::uint32_t kUnlimitedBounces = std::numeric_limits<std::uint32_t>::max();
inline constexpr std::uint32_t kAllPathKinds = (1U << kPathKindCount) - 1U;

/// How light sampling chooses one of several lights.
enum class LightSelection : std::uint32_t {
  Auto,  ///< by the tree where lights are spread out
  Power, ///< in proportion to their power
  Tree,  ///< by what they may bring to the place: src/device/light_tree.h
};

struct EstimatorSettings {
  Sampler sampler = Sampler::Independent;
  LightStrategy light = LightStrategy::Mis;
  LightSelection lightSelection = LightSelection::Power;
  LightTracing lightTracing = LightTracing::Off;
  Guiding guiding = Guiding::Off;
  std::uint32_t lightSamples = 1;               ///< shadow rays at a surface point, 1 to kMaxLightSamples
  std::uint32_t maxBounces = kUnlimitedBounces; ///< 0: emitted light only, 1: + direct light, ...
  RouletteMode roulette = RouletteMode::Throughput;
  double termination = 0.5;                     ///< RouletteMode::Constant: the probability to end, [0, 1)
  std::optional<std::uint32_t> rouletteAfter{}; ///< first bounce after whose direct light a path may end
  /// At smooth dielectrics both branches are followed up to this trace depth; specular surfaces end no path
  /// by roulette up to it. 0 to kMaxSplitDepth.
  std::uint32_t splitDepth = 0;
  /// Paths of a sample whose first surface is specular, through the same point of the image: 1 to
  /// kMaxSpecularSamples.
  std::uint32_t specularSamples = 1;
  std::uint32_t pathReuse = 1; ///< pixels that share their paths, a square of 1, 2, 4 or 8 on a side
  std::uint32_t pathKinds = kAllPathKinds; ///< bit i: PathKind i is rendered
  bool kindImages = false;                 ///< an image of each kind beside the whole

  [[nodiscard]] std::uint32_t effectiveRouletteAfter() const;
  [[nodiscard]] std::uint32_t reuseEdge() const; ///< of the square of pathReuse pixels
  bool operator==(const EstimatorSettings&) const = default;
};

inline std::uint32_t EstimatorSettings::reuseEdge() const {
  std::uint32_t edge = 1;
  while (edge < shared::kBlockEdge && edge * edge < pathReuse)
    edge *= 2;
  return edge;
}

inline std::uint32_t EstimatorSettings::effectiveRouletteAfter() const {
  switch (roulette) {
  case RouletteMode::Albedo:
    return rouletteAfter.value_or(1);
  case RouletteMode::Throughput:
    return rouletteAfter.value_or(3);
  case RouletteMode::Constant:
    return rouletteAfter.value_or(2);
  }
  return rouletteAfter.value_or(3);
}

} // namespace vkpt
