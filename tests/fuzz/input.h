#pragma once
// Inputs as files: the loaders are fuzzed from the name of a file on.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace vkpt::test {

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Into the working folder, which is the fuzzer's own.
inline void writeFile(const std::string& name, std::string_view text) {
  std::ofstream(name, std::ios::binary | std::ios::trunc) << text;
}

} // namespace vkpt::test
