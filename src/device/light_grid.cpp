#include "device/light_grid.h"

#include "device/light_table.h"
#include "device/light_table_quality.h"
#include "device/light_tables.h"
#include "device/packed_light_node.h"
#include "shared/structs.h"

#include <algorithm>
#include <bit>
#include <queue>

namespace vkpt {
namespace {

using shared::kAnySide;
using shared::kLightGridCubes;
using shared::kLightGridEdge;
using shared::kLightGridSides;

/// The nodes that a table chooses from: those that are largest and brightest are divided first.
std::vector<std::uint32_t> cutThrough(const PackedScene& scene) {
  std::priority_queue<std::pair<double, std::uint32_t>> open;
  std::vector<std::uint32_t> cut;
  const auto add = [&](std::uint32_t i) {
    const PackedLightNode node = lightNodeOf(scene, i);
    if (node.leaf)
      cut.push_back(i);
    else
      open.emplace(node.power * node.radius, i);
  };
  add(0);
  while (!open.empty() && cut.size() + open.size() < 1U << shared::kMostLightTableBits) {
    const std::uint32_t first = lightNodeOf(scene, open.top().second).below;
    open.pop();
    add(first);
    add(first + 1);
  }
  for (; !open.empty(); open.pop())
    cut.push_back(open.top().second);
  // Where they are lights alone, a light's bin has its number.
  std::ranges::sort(cut, {}, [&](std::uint32_t i) { return lightNodeOf(scene, i).below; });
  return cut;
}

/// The numbers of PackedScene::lightGrid before any cube has a table: all begin with one by power.
void begin(PackedScene& scene, std::span<const std::uint32_t> cut, std::size_t bins) {
  constexpr std::uint32_t kHead = (kLightGridCubes + 1U) * kLightGridSides;
  std::vector<std::uint32_t>& numbers = scene.lightGrid;
  numbers.assign(kHead, static_cast<std::uint32_t>(kHead + bins));
  BinWeights powers(bins);
  for (std::size_t bin = 0; bin < cut.size(); ++bin) {
    const PackedLightNode node = lightNodeOf(scene, cut[bin]);
    numbers.push_back(node.below | (node.leaf ? shared::kLightLeaf : 0U));
    powers[bin] = node.power;
    setLightBin(scene, cut[bin], static_cast<std::uint32_t>(bin + 1));
  }
  numbers.resize(kHead + bins);
  appendLightTable(std::move(powers), cut.size(), numbers);
}

void append(PackedScene& scene, std::span<const SideTables> tables) {
  std::vector<std::uint32_t>& numbers = scene.lightGrid;
  for (std::size_t cube = 0; cube < tables.size(); ++cube) {
    const SideTables& sides = tables[cube];
    if (sides[kAnySide].empty())
      continue;
    std::array<std::uint32_t, kLightGridSides> start{};
    for (std::uint32_t side = 0; side < kLightGridSides; ++side) {
      start[side] = static_cast<std::uint32_t>(numbers.size());
      numbers.insert(numbers.end(), sides[side].begin(), sides[side].end());
    }
    for (std::uint32_t side = 0; side < kLightGridSides; ++side)
      numbers[cube * kLightGridSides + side] = start[sides[side].empty() ? kAnySide : side];
  }
}

/// Triangles that are lights, and the environment, by their bins in place of their leaves.
void numberByBins(PackedScene& scene) {
  for (std::uint32_t i = 0; i < scene.lightChoice.count; ++i) {
    const std::uint32_t what = scene.lights[std::size_t{i} * shared::kTexelsPerLight + 3][3];
    if (what == shared::kLightEnvironment)
      scene.lightChoice.environmentLeaf = i;
    else if (what < shared::kLightEnvironment)
      scene.triangles[std::size_t{what} * shared::kTexelsPerTriangle + 2][3] = i;
  }
}

} // namespace

void makeLightGrid(PackedScene& scene, const Scene& source,
                   const std::function<LightGridFunctions()>& functions, unsigned threads) {
  if (!scene.lightChoice.byTree)
    return;
  const std::vector<std::uint32_t> cut = cutThrough(scene);
  LightChoice& choice = scene.lightChoice;
  const std::vector<std::uint32_t> before = scene.lightGrid;
  choice.tableBits = std::max(static_cast<std::uint32_t>(std::bit_width(cut.size() - 1)), 4U);
  const std::size_t bins = std::size_t{1} << choice.tableBits;
  const CubeGrid grid = gridAbout(sceneBox(source), kLightGridEdge);
  begin(scene, cut, bins);
  append(scene, lightTables(grid, source, cut, bins, functions, threads));
  if (!tablesChooseAsWell(scene, source, grid, functions())) {
    scene.lightGrid = before;
    choice.tableBits = LightChoice{}.tableBits;
    for (const std::uint32_t node : cut)
      setLightBin(scene, node, 0);
    return;
  }
  choice.grid = grid;
  choice.byTables = true;
  choice.belowTables = std::ranges::any_of(cut, [&](std::uint32_t i) { return !lightNodeOf(scene, i).leaf; });
  if (!choice.belowTables)
    numberByBins(scene);
}

} // namespace vkpt
