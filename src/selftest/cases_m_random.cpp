// Random numbers: never 1, never the same twice, and independent of their neighbours'.
#include "selftest/case.h"
#include "selftest/functions.h"
#include "selftest/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace vkpt::selftest {
namespace {

Row bitsRow(std::uint32_t x, std::uint32_t y = 0, std::uint32_t z = 0, std::uint32_t w = 0) {
  const auto f = [](std::uint32_t bits) { return std::bit_cast<float>(bits); };
  return {{f(x), f(y), f(z), f(w)}, {}};
}

/// The last 2^16 of the 2^32 numbers, where rounding could give 1, the first, and every 65 537th.
void unitInterval(Trial& t) {
  std::vector<Row> rows;
  constexpr std::uint32_t kEnd = 1U << 16U;
  for (std::uint32_t i = 0; i < kEnd; ++i) {
    rows.push_back(bitsRow(0xFFFFFFFFU - i));
    rows.push_back(bitsRow(i));
    rows.push_back(bitsRow(i * 65537U));
  }
  float least = 2.0F;
  float most = -1.0F;
  for (const Row& r : evaluate(t, Function::ToUnit, rows)) {
    least = std::min(least, r.a[0]);
    most = std::max(most, r.a[0]);
  }
  t.atMost("largest", double{most}, 1.0 - 0x1p-24);
  t.atLeast("smallest", double{least}, 0.0);
}

using Numbers = std::array<std::uint32_t, 4>;

std::vector<Numbers> blocks(const Trial& t, std::span<const Row> counters) {
  std::vector<Numbers> numbers;
  for (const Row& r : evaluate(t, Function::RandomBlock, counters))
    numbers.push_back(std::bit_cast<Numbers>(r.a));
  return numbers;
}

constexpr std::uint32_t kSquareEdge = 256; // pixels, and samples
constexpr std::uint32_t kKey = 12345;

/// By pixel (column) and sample (row).
std::vector<Row> counters(std::uint32_t pixelShift, std::uint32_t sampleShift, std::uint32_t block = 0,
                          std::uint32_t key = kKey) {
  std::vector<Row> rows;
  for (std::uint32_t sample = 0; sample < kSquareEdge; ++sample) {
    for (std::uint32_t pixel = 0; pixel < kSquareEdge; ++pixel)
      rows.push_back(bitsRow(pixel + pixelShift, sample + sampleShift, block, key));
  }
  return rows;
}

std::vector<double> units(const std::vector<Numbers>& numbers, std::size_t dimension) {
  std::vector<double> u;
  for (const Numbers& n : numbers)
    u.push_back(static_cast<double>(n.at(dimension)) * 0x1p-32);
  return u;
}

/// Pearson's r of 65 536 numbers and their neighbours': of the next pixel, sample, bounce, seed, dimension,
/// and of the pixel before in the next sample, where seeds that are sums repeat.
void correlations(Trial& t) {
  const std::vector<Numbers> here = blocks(t, counters(1, 1));
  const std::vector<double> u = units(here, 0);
  const double bound = 4.5 / std::sqrt(static_cast<double>(u.size()));
  const auto look = [&](const char* name, const std::vector<Numbers>& other, std::size_t dimension = 0) {
    t.atMost(name, std::abs(correlation(u, units(other, dimension))), bound);
  };
  look("next pixel", blocks(t, counters(2, 1)));
  look("next sample", blocks(t, counters(1, 2)));
  look("next sample, pixel before", blocks(t, counters(0, 2)));
  look("next bounce", blocks(t, counters(1, 1, 1)));
  look("next seed", blocks(t, counters(1, 1, 0, kKey + 1)));
  look("second number of the block", here, 1);
  look("third number of the block", here, 2);
  look("fourth number of the block", here, 3);
}

/// 2^20 blocks of 128 bits for pixels and samples: one that comes twice has had the same counter.
void noRepeats(Trial& t) {
  std::vector<Numbers> all;
  for (std::uint32_t tile = 0; tile < 16; ++tile) {
    const std::vector<Numbers> some = blocks(t, counters(tile * kSquareEdge, 0));
    all.insert(all.end(), some.begin(), some.end());
  }
  std::ranges::sort(all);
  std::size_t repeats = 0;
  for (std::size_t i = 1; i < all.size(); ++i)
    repeats += all[i] == all[i - 1] ? 1U : 0U;
  t.atMost("blocks of random numbers that repeat, of 2^20", static_cast<double>(repeats), 0.0);
}

constexpr Case kRandomCases[] = {
    {"m6-no-repeats", "no two of a million pixels and samples have the same random numbers", noRepeats},
    {"m7-unit-interval", "random numbers are at least 0 and never 1", unitInterval},
    {"m8-correlation", "neighbours in pixel, sample, bounce, seed and dimension are independent",
     correlations},
};

} // namespace

std::span<const Case> randomCases() { return kRandomCases; }

} // namespace vkpt::selftest
