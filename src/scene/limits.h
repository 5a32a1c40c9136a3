#pragma once
// Ranges of what scene files say, for every format.

namespace vkpt {

/// Of a colour's channel: products of a few such values stay in the range of float.
inline constexpr double kLargestColour = 1e12;
/// Sums that are 1 in decimals count as 1.
inline constexpr double kSumRounding = 1e-9;

/// Of an index of refraction: its square, and that of its inverse, stay in the range of float.
inline constexpr double kLeastIor = 1e-6;
inline constexpr double kLargestIor = 1e6;

/// Of a rough material's alpha: narrower lobes are a few hundred ulp wide, too narrow to be evaluated in
/// float, and the surface is taken as smooth.
inline constexpr double kLeastRoughness = 1e-4;

} // namespace vkpt
