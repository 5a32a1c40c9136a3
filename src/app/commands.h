#pragma once
#include "app/options.h"

namespace vkpt {

ExitCode runRender(const RenderOptions& options);
ExitCode runDevices(const RenderOptions& options);
ExitCode runListScenes();

} // namespace vkpt
