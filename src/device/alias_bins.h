#pragma once
// Choices among bins by an alias table in whole numbers, so that a share is exactly what is drawn.

#include <cstdint>
#include <span>
#include <vector>

namespace vkpt {

/// Appends a number for every bin, of which there are a power of two, 2 to 2^15: its share of kAliasUnits in
/// proportion to the weights (16 bits), then threshold and alias of the alias table's row, in 16 bits
/// together (shaders/lib/records.glsl: AliasBin). The weights' sum is above 0. A bin of less than a unit may
/// get none, and one that has all leaves a unit to another. Walker 1977; Vose 1991.
void appendAliasBins(std::span<const double> weights, std::vector<std::uint32_t>& out);

} // namespace vkpt
