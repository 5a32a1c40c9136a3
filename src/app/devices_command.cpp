#include "app/commands.h"
#include "gpu/context.h"
#include "scene/load.h"

#include <fmt/format.h>

namespace vkpt {

ExitCode runDevices(const RenderOptions& options) {
  const auto devices = gpu::listDevices();
  const std::size_t chosen = gpu::chooseDevice(devices, options.device);
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const auto& d = devices[i];
    fmt::print("{} {}: {} ({}, {}, Vulkan {})\n", i == chosen ? '*' : ' ', i, d.name, d.type, d.driver,
               d.api);
  }
  fmt::print("* would be used; choose another with --device INDEX or part of its NAME\n");
  return ExitCode::Done;
}

ExitCode runListScenes() {
  for (const auto& scene : builtinScenes())
    fmt::print("{:<18} {}\n", scene.name, scene.description);
  return ExitCode::Done;
}

} // namespace vkpt
