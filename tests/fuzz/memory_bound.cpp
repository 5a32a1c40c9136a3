#include "fuzz/memory_bound.h"

#include <sanitizer/allocator_interface.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace vkpt::test {

namespace {

std::atomic<bool> watching{false};
std::atomic<long long> inUse{0};
std::atomic<long long> limit{0};

void onMalloc(const volatile void*, std::size_t size) {
  if (!watching) {
    return;
  }
  const auto bytes = static_cast<long long>(size);
  if ((inUse += bytes) > limit) {
    watching = false;
    std::fprintf(stderr, "memory: %lld bytes in use, the last %lld at once; the input justifies %lld\n",
                 inUse.load(), bytes, limit.load());
    std::abort();
  }
}

/// What was allocated before counts below 0: frees of it are few.
void onFree(const volatile void* memory) {
  if (watching && memory != nullptr) {
    inUse -= static_cast<long long>(__sanitizer_get_allocated_size(memory));
  }
}

} // namespace

MemoryBound::MemoryBound(std::size_t bytes) {
  static const int installed = __sanitizer_install_malloc_and_free_hooks(onMalloc, onFree);
  if (installed == 0) {
    std::abort();
  }
  inUse = 0;
  limit = static_cast<long long>(bytes);
  watching = true;
}

MemoryBound::~MemoryBound() { watching = false; }

} // namespace vkpt::test
