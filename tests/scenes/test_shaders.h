#pragma once
// The shaders of these tests alone, and the switch of the mutations.

#include "shared/mutations.h"

#include <cstdint>
#include <span>

namespace vkpt::spirv {

extern const std::span<const std::uint32_t> kMutablePath;  ///< path.comp with VKPT_MUTATIONS
extern const std::span<const std::uint32_t> kMutableMerge; ///< merge.comp with VKPT_MUTATIONS
extern const std::span<const std::uint32_t> kLoopLimit;    ///< loop_limit.comp
extern const std::span<const std::uint32_t> kDivergence;   ///< divergence.comp

} // namespace vkpt::spirv

namespace vkpt::test {

inline constexpr std::uint32_t kMutationConstant = 127; ///< constant_id of kMutation

enum class Mutation : std::uint32_t {
#define VKPT_ENUMERATOR(id, Name, what) Name = id,
  VKPT_MUTATIONS_LIST(VKPT_ENUMERATOR)
#undef VKPT_ENUMERATOR
};

struct MutationInfo {
  Mutation mutation;
  const char* name;
  const char* what; ///< what is broken
};

inline constexpr MutationInfo kMutations[] = {
#define VKPT_ROW(id, Name, what) {Mutation::Name, #Name, what},
    VKPT_MUTATIONS_LIST(VKPT_ROW)
#undef VKPT_ROW
};

} // namespace vkpt::test
