#pragma once
// The self-test's own shaders, beside those of the estimator.

#include <cstdint>
#include <span>

namespace vkpt::spirv {

extern const std::span<const std::uint32_t> kFunctions;   ///< probe/functions.comp
extern const std::span<const std::uint32_t> kPathRecords; ///< probe/path_records.comp
extern const std::span<const std::uint32_t> kSums;        ///< probe/sums.comp
extern const std::span<const std::uint32_t> kLoopLimit;   ///< probe/loop_limit.comp
extern const std::span<const std::uint32_t> kDivergence;  ///< probe/divergence.comp

} // namespace vkpt::spirv
