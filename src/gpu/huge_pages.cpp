#include "gpu/huge_pages.h"

#include <sys/mman.h>

#include <memory>

namespace vkpt::gpu {

void adviseHugePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kHugePage = 2U << 20U; // x86-64, and arm64 with pages of 4 KB
  // Whole ones alone: what lies beside the buffer is not ours.
  if (std::align(kHugePage, kHugePage, memory, bytes) != nullptr)
    (void)madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
#endif
}

} // namespace vkpt::gpu
