#pragma once
// The film's mergeGroup() on the device, on groups that the test makes.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vkpt::test {

inline constexpr std::size_t kMergeStreams = 64;

/// Moments of one group of kSamplesPerGroup samples.
struct GroupMoments {
  float mean;
  float deviations;
};

/// Pairs of floats as the film holds them.
struct PairMoments {
  float meanHigh;
  float meanLow;
  float deviationsHigh;
  float deviationsLow;
  [[nodiscard]] double mean() const { return static_cast<double>(meanHigh) + static_cast<double>(meanLow); }
  [[nodiscard]] double deviations() const {
    return static_cast<double>(deviationsHigh) + static_cast<double>(deviationsLow);
  }
};

/// Group g of stream s is groups[g * kMergeStreams + s]. `mutation`: as in Kernel.
std::vector<PairMoments> mergeOnDevice(std::span<const GroupMoments> groups, std::uint32_t mutation);

} // namespace vkpt::test
