#pragma once
// Whole files in, atomic files out.

#include "core/error.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace vkpt::film {

using Bytes = std::vector<unsigned char>;
using ByteView = std::span<const unsigned char>;

/// Throws SceneError naming the file and the system's reason.
Bytes readWholeFile(const fs::path& path);

/// A file that is there as a whole or not at all: what is written goes into a temporary file in the target's
/// folder, and commit() puts that in the target's place. Without a commit the temporary is removed.
class AtomicFile {
public:
  /// Throws UsageError where the target is something else than a file, its folder is missing, or no file can
  /// be made there.
  explicit AtomicFile(const fs::path& target);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Never throws, since codecs in C call it: the first failure is kept for commit(), and later writes do
  /// nothing.
  void write(ByteView bytes) noexcept;
  void seek(std::uint64_t position) noexcept { m_position = position; }
  [[nodiscard]] std::uint64_t position() const noexcept { return m_position; } ///< bytes from the start

  /// Onto the disk, and in the target's place. Throws Error (usage) with the system's reason.
  void commit();

private:
  [[noreturn]] void fail(int reason) const;

  fs::path m_target;
  fs::path m_temporary; ///< empty once committed
  int m_file = -1;
  int m_error = 0; ///< errno of the first failed write
  std::uint64_t m_position = 0;
};

/// Throws as AtomicFile does.
void writeTextFile(const fs::path& path, std::string_view text);

} // namespace vkpt::film
