#pragma once
// Pearson's test of counts against expected ones.

#include <span>
#include <string>

namespace vkpt::test {

struct ChiSquare {
  double statistic = 0.0;
  int freedom = 0;
  double probability = 1.0; ///< of a statistic this large by chance
  [[nodiscard]] std::string figures() const;
};

/// Cells are taken in the order of what is expected of them, and pooled until at least 5 are.
/// Counts where nothing is expected have probability 0.
ChiSquare chiSquare(std::span<const double> observed, std::span<const double> expected);

} // namespace vkpt::test
