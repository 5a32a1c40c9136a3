#pragma once
// A folder that a command fills: looked at before anything is loaded, made before anything is rendered.

#include "core/error.h"

namespace vkpt {

/// Throws UsageError where something else than a folder stands there, or a folder with files in it, which
/// `force` allows.
void checkFolder(const fs::path& folder, bool force);
/// Makes it; throws UsageError where that, or a file of this name in it, cannot be made.
void makeFolder(const fs::path& folder, const char* file);

} // namespace vkpt
