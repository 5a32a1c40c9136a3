#pragma once
#include "core/error.h"

namespace vkpt {

/// Where compiled pipelines are kept: $XDG_CACHE_HOME/vkpt, else ~/.cache/vkpt; empty where neither is known.
fs::path pipelineCacheFolder();

} // namespace vkpt
