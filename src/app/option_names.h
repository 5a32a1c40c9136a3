#pragma once
// What the values of options are called.

#include "device/estimator_settings.h"

#include <array>
#include <string_view>

namespace vkpt {

/// In the order of the enumerators.
inline constexpr std::array<std::string_view, 3> kLightNames{"nee", "bsdf", "mis"};
inline constexpr std::array<std::string_view, 3> kRouletteNames{"albedo", "throughput", "constant"};
inline constexpr std::array<std::string_view, kPathKindCount> kKindNames{
    "emission", "direct", "caustic", "indirect", "indirect-caustic", "specular"};
inline constexpr std::array<std::string_view, 4> kFilterNames{"box", "tent", "gaussian", "mitchell"};
inline constexpr std::array<std::string_view, 3> kTonemapNames{"none", "srgb", "aces"};

inline constexpr std::array<std::string_view, 2> kSamplerNames{"independent", "sobol"};
inline constexpr std::array<std::string_view, 3> kLightSelectionNames{"auto", "power", "tree"};
inline constexpr std::array<std::string_view, 3> kLightTracingNames{"auto", "on", "off"};
inline constexpr std::array<std::string_view, 2> kGuidingNames{"auto", "off"};

template<std::size_t N, class Enum>
std::string_view nameOf(const std::array<std::string_view, N>& names, Enum value) {
  return names.at(static_cast<std::size_t>(value));
}

} // namespace vkpt
