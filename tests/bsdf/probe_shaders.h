#pragma once
// probe.comp, and the switch of the mutations that these tests notice.

#include "shared/mutations.h"

#include <cstdint>
#include <span>

namespace vkpt::spirv {

extern const std::span<const std::uint32_t> kProbe;
extern const std::span<const std::uint32_t> kMutableProbe; ///< with VKPT_MUTATIONS

} // namespace vkpt::spirv

namespace vkpt::test {

struct SamplingMutation {
  std::uint32_t id;
  const char* name;
  const char* what; ///< is broken
};
inline constexpr SamplingMutation kSamplingMutations[] = {
#define VKPT_ROW(id, Name, what) {id, #Name, what},
    VKPT_SAMPLING_MUTATIONS_LIST(VKPT_ROW)
#undef VKPT_ROW
};

} // namespace vkpt::test
