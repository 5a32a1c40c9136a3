#include "device/alias_bins.h"

#include "shared/structs.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>
#include <utility>

namespace vkpt {
namespace {

using shared::kAliasUnits;
constexpr std::uint32_t kMostUnits = kAliasUnits - 1; ///< of a bin

using Units = std::vector<std::uint32_t>;

/// Whole shares in proportion to the weights, kAliasUnits together; 16 bits hold each.
Units apportion(std::span<const double> weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto bins = static_cast<std::uint32_t>(weights.size());
  Units units(bins);
  std::vector<std::pair<double, std::uint32_t>> rest(bins);
  std::uint32_t given = 0;
  for (std::uint32_t i = 0; i < bins; ++i) {
    const double exact = weights[i] / sum * kAliasUnits;
    units[i] = std::min(static_cast<std::uint32_t>(exact), kMostUnits);
    rest[i] = {units[i] - exact, i};
    given += units[i];
  }
  std::ranges::sort(rest); // those that lack the most first
  for (std::uint32_t i = 0; given < kAliasUnits; ++i) {
    std::uint32_t& unit = units[rest[i % bins].second];
    if (unit < kMostUnits) {
      ++unit;
      ++given;
    }
  }
  return units;
}

} // namespace

void appendAliasBins(std::span<const double> weights, std::vector<std::uint32_t>& out) {
  const Units units = apportion(weights);
  const auto bins = static_cast<std::uint32_t>(units.size());
  const auto bits = static_cast<std::uint32_t>(std::countr_zero(bins));
  assert(std::has_single_bit(bins) && bits > 0 && bits < 16);
  const std::uint32_t rowUnits = kAliasUnits / bins;
  Units left = units;
  Units alias(bins);
  Units threshold(bins);
  std::vector<std::uint32_t> below, above;
  for (std::uint32_t i = 0; i < bins; ++i)
    (units[i] < rowUnits ? below : above).push_back(i);
  while (!below.empty()) {
    const std::uint32_t row = below.back();
    const std::uint32_t giver = above.back(); // there is one: all rows are filled together
    below.pop_back();
    threshold[row] = left[row];
    alias[row] = giver;
    left[giver] -= rowUnits - left[row];
    if (left[giver] < rowUnits) {
      above.pop_back();
      below.push_back(giver);
    }
  }
  for (const std::uint32_t full : above)
    alias[full] = full;
  for (std::uint32_t i = 0; i < bins; ++i)
    out.push_back(units[i] | (threshold[i] << 16U) | (alias[i] << (32U - bits)));
}

} // namespace vkpt
