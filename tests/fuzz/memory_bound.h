#pragma once
// No allocation above what the file justifies.

#include <cstddef>

namespace vkpt::test {

/// While one lives, the process dies with a message, which libFuzzer takes for a crash, as soon as more than
/// `bytes` that were allocated since are in use.
class MemoryBound {
public:
  explicit MemoryBound(std::size_t bytes);
  ~MemoryBound();
  MemoryBound(const MemoryBound&) = delete;
  MemoryBound& operator=(const MemoryBound&) = delete;
};

} // namespace vkpt::test
