#pragma once
// The tables of the grid of lights, by cube and side: part of light_grid.h.

#include "device/light_grid.h"
#include "shared/structs.h"

#include <array>
#include <span>

namespace vkpt {

/// Of a table's bins, of which there are a power of two; nodes of the cut first.
using BinWeights = std::vector<double>;
/// Appends a table of these weights in which each of the first `nodes` bins has a share, and no other.
void appendLightTable(BinWeights weights, std::size_t nodes, std::vector<std::uint32_t>& out);

/// Of one cube, by side; empty where it has no table.
using SideTables = std::array<std::vector<std::uint32_t>, shared::kLightGridSides>;
/// By cube: guideCube().
std::vector<SideTables> lightTables(const CubeGrid& grid, const Scene& scene,
                                    std::span<const std::uint32_t> cut, std::size_t bins,
                                    const std::function<LightGridFunctions()>& functions, unsigned threads);

} // namespace vkpt
