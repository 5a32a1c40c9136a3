#include "app/output_folder.h"

#include "film/file_io.h"

#include <fmt/format.h>

namespace vkpt {

void checkFolder(const fs::path& folder, bool force) {
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw UsageError(fmt::format("--output '{}': expected a folder, and this is none", folder.string()));
  if (fs::is_directory(folder) && !fs::is_empty(folder) && !force)
    throw UsageError(
        fmt::format("--output '{}': there are files in it; --force writes over those of the same names",
                    folder.string()));
}

void makeFolder(const fs::path& folder, const char* file) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    throw UsageError(fmt::format("--output '{}': {}", folder.string(), failure.message()));
  const film::AtomicFile trial(folder / file); // not committed: removed again
}

} // namespace vkpt
