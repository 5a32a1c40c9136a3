#pragma once
// FNV-1a: stable across runs and machines, for cache keys and seeds that come from a name; not for security.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace vkpt {

std::uint64_t hashBytes(std::span<const std::byte> bytes, std::uint64_t basis = 0xCBF29CE484222325ULL);
std::uint64_t hashText(std::string_view text);

} // namespace vkpt
