#include "app/cache_folder.h"

#include <cstdlib>

namespace vkpt {

fs::path pipelineCacheFolder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && fs::path(cache).is_absolute()) // the specification has relative ones ignored
    return fs::path(cache) / "vkpt";
  const char* home = std::getenv("HOME");
  return home != nullptr && fs::path(home).is_absolute() ? fs::path(home) / ".cache" / "vkpt" : fs::path();
}

} // namespace vkpt
