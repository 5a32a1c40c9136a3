// Memory of buffers.
#include "gpu/buffer.h"
#include "scenes/render_fixture.h"

#include <fstream>
#include <sstream>

namespace vkpt::test {
namespace {

/// The kernel's flags of the mapping that holds `address` (proc_pid_smaps(5), VmFlags); empty where it says
/// none.
std::string mappingFlags(const void* address) {
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream maps("/proc/self/smaps");
  bool inside = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t first = 0;
    std::uintptr_t end = 0;
    char dash = 0;
    std::istringstream range(line);
    if (range >> std::hex >> first >> dash >> end && dash == '-')
      inside = first <= wanted && wanted < end;
    else if (inside && line.starts_with("VmFlags:"))
      return line;
  }
  return {};
}

/// Whether the system follows the hint at all.
bool hasHugePages() {
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string choice;
  std::getline(file, choice);
  return choice.find("[madvise]") != std::string::npos || choice.find("[always]") != std::string::npos;
}

using Buffers = RenderTest;

/// All of it but what is less than a huge page at either end, and no byte outside it.
TEST_F(Buffers, LargeOnesLieInHugePages) {
  if (!hasHugePages())
    GTEST_SKIP() << "the system has no huge pages for those who ask";
  constexpr std::size_t kMiB = 1U << 20U;
  const gpu::Buffer buffer(sharedContext(), "test", 16 * kMiB, {}, gpu::MemoryKind::Device);
  if (buffer.mapped() == nullptr)
    GTEST_SKIP() << "the host can't see the device's memory";
  const auto* const first = static_cast<const std::byte*>(buffer.mapped());
  for (std::size_t i = 2; i < 14; ++i)
    EXPECT_NE(mappingFlags(first + i * kMiB).find(" hg"), std::string::npos) << i << " MiB";
  const bool startsOne = reinterpret_cast<std::uintptr_t>(first) % (2 * kMiB) == 0;
  EXPECT_EQ(mappingFlags(first).find(" hg") != std::string::npos, startsOne);
}

} // namespace
} // namespace vkpt::test
