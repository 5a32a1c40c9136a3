#include "scenes/merge_program.h"

#include "scenes/render_fixture.h"
#include "scenes/test_shaders.h"
#include "selftest/small_program.h"

namespace vkpt::test {

std::vector<PairMoments> mergeOnDevice(std::span<const GroupMoments> groups, std::uint32_t mutation) {
  std::vector<PairMoments> merged(kMergeStreams);
  runSmallProgram(sharedContext(), {spirv::kMutableMerge, mutatedKernel(mutation).constants()},
                  std::as_bytes(groups), std::as_writable_bytes(std::span{merged}));
  return merged;
}

} // namespace vkpt::test
