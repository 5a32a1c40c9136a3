#pragma once
// The shaders of these tests alone, and the switch of the mutations.

#include "selftest/render_scene.h"
#include "shared/mutations.h"

namespace vkpt::spirv {

extern const std::span<const std::uint32_t> kMutablePath; ///< path.comp with VKPT_MUTATIONS
extern const std::span<const std::uint32_t> kMutableFirstVertices;
extern const std::span<const std::uint32_t> kMutableSharePaths;
extern const std::span<const std::uint32_t> kMutableFunctions;
extern const std::span<const std::uint32_t> kMutablePathRecords;
extern const std::span<const std::uint32_t> kMutableSums;
extern const std::span<const std::uint32_t> kMutableMerge; ///< merge.comp with VKPT_MUTATIONS

} // namespace vkpt::spirv

namespace vkpt::test {

/// The test build of the kernels with this mistake switched on; 0: with none.
selftest::Kernel mutatedKernel(std::uint32_t mutation);

enum class Mutation : std::uint32_t {
#define VKPT_ENUMERATOR(id, Name, what) Name = id,
  VKPT_MUTATIONS_LIST(VKPT_ENUMERATOR)
#undef VKPT_ENUMERATOR
};

enum class GeometryMutation : std::uint32_t {
#define VKPT_ENUMERATOR(id, Name, what) Name = id,
  VKPT_GEOMETRY_MUTATIONS_LIST(VKPT_ENUMERATOR)
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
