#include "core/hash.h"

namespace vkpt {

std::uint64_t hashBytes(std::span<const std::byte> bytes, std::uint64_t basis) {
  std::uint64_t h = basis;
  for (const std::byte b : bytes)
    h = (h ^ static_cast<std::uint64_t>(b)) * 0x100000001B3ULL;
  return h;
}

std::uint64_t hashText(std::string_view text) {
  return hashBytes(std::as_bytes(std::span{text.data(), text.size()}));
}

} // namespace vkpt
