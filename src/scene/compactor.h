#pragma once
// Indices of a file's list into those of a scene's list that holds only what is used.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vkpt {

/// Maps indices of a file to the scene's, in the order of first use.
class Compactor {
public:
  explicit Compactor(std::size_t count) : m_map(count, kUnused) {}

  /// `append(index)` puts the element into the scene and returns where it is now; called once an index.
  template<class Append>
  std::uint32_t operator()(std::uint32_t index, const Append& append) {
    if (m_map[index] == kUnused) {
      m_map[index] = append(index);
    }
    return m_map[index];
  }

private:
  static constexpr std::uint32_t kUnused = 0xFFFFFFFFU;
  std::vector<std::uint32_t> m_map;
};

} // namespace vkpt
