#include "scenes/merge_program.h"

#include "scenes/small_program.h"
#include "scenes/test_shaders.h"

namespace vkpt::test {

std::vector<PairMoments> mergeOnDevice(std::span<const GroupMoments> groups, std::uint32_t mutation) {
  std::vector<PairMoments> merged(kMergeStreams);
  runSmallProgram(spirv::kMutableMerge, {{kMutationConstant, mutation}}, std::as_bytes(groups),
                  std::as_writable_bytes(std::span{merged}));
  return merged;
}

} // namespace vkpt::test
