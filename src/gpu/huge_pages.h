#pragma once

#include <cstddef>

namespace vkpt::gpu {

/// Asks the system to back `bytes` at `memory` with its huge pages, where it has them (Linux, madvise(2)). A
/// hint: where it is not followed, all is as it was.
///
/// Memory of a device that is the processor itself is ordinary memory. The rays of a subgroup read a large
/// scene in eight places at once, and pages of 4 KB are then too many for the processor to remember where
/// each lies.
void adviseHugePages(void* memory, std::size_t bytes);

} // namespace vkpt::gpu
