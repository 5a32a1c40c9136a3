#pragma once
#include "app/options.h"

namespace vkpt {

ExitCode runRender(const RenderOptions& options);
ExitCode runDevices(const RenderOptions& options);
/// Prints one path of the scene vertex by vertex, in float and in double; needs no device.
ExitCode runReplay(const RenderOptions& options);
/// Which effects the scene calls for, because of what, what they take, and the memory that a render needs.
ExitCode runExplain(const RenderOptions& options);
ExitCode runListScenes();
/// With options of their own: the arguments behind the command's name.
ExitCode runCompare(const std::vector<std::string>& arguments);
ExitCode runAssignment(const std::vector<std::string>& arguments);
ExitCode runSelftest(const std::vector<std::string>& arguments);
ExitCode runStudy(const std::vector<std::string>& arguments);

} // namespace vkpt
