// vkpt-view, which `vkpt view` starts: parses the options, opens the window and hands over to the session.

#include "app/cache_folder.h"
#include "app/run_program.h"
#include "app/view/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace {

using namespace vkpt;

constexpr const char* kHelp =
    "vkpt view: a progressive preview in a window.\n"
    "Usage: vkpt view [SCENE...] [options]\n\n"
    "All options of vkpt for scene, camera, estimator and display hold (vkpt --help); without a rule to stop "
    "it\n"
    "refines without end. Besides:\n"
    "  --close        close the window when a rule to stop is met\n"
    "  --log-events   what happens, as lines of JSON on stdout\n\n"
    "Mouse: left drag orbits about the point that a click sets, middle drag or Shift pans, the wheel "
    "dollies;\n"
    "       with the right button held the mouse looks about and W A S D Q E fly, faster with Shift.\n"
    "       A middle click tells what a pixel is made of.\n"
    "Keys:  0 base colour, 1 direct light, 2 normals, 3 path tracing; r or t: path tracing on and off\n"
    "       + - exposure, * tonemap, e standard error, p pause, h panel, f frame the scene, Home first "
    "camera\n"
    "       b or Ctrl+S saves PNG and EXR (to --output, else SCENE-1.png, ...), c prints the camera, Esc "
    "quits\n\n"
    "Examples:\n"
    "  vkpt view cornell-spheres\n"
    "  vkpt view room.obj --size 960x540 --background 0.5,0.7,1 --target-error 0.05\n";

/// Whether it was there; takes it out.
bool takeFlag(std::vector<std::string>& arguments, const char* name) {
  return std::erase(arguments, name) > 0;
}

ExitCode run(std::vector<std::string> arguments) {
  SessionOptions options;
  options.logEvents = takeFlag(arguments, "--log-events");
  options.close = takeFlag(arguments, "--close");
  if (takeFlag(arguments, "--help") || takeFlag(arguments, "-h")) {
    fmt::print("{}", kHelp);
    return ExitCode::Done;
  }
  CommandLine line = parseCommandLine(arguments);
  if (line.command == Command::Exit)
    return ExitCode::Done;
  if (line.command != Command::Render)
    throw UsageError("view: only the options of render go with it; see vkpt view --help");
  RenderOptions& o = options.render = line.render;
  if (!o.kindPrefix.empty())
    throw UsageError("--output-paths: not an option of view; see vkpt view --help");
  if (o.pilotSeconds)
    throw UsageError("--pilot: not an option of view; see vkpt view --help");
  options.outputsNamed = std::ranges::any_of(arguments, [](const std::string& word) {
    return word.starts_with("-o") || word.starts_with("--output");
  });
  o.endless = true;
  setUpLog(o.log);
  if (options.outputsNamed || !o.stats.empty())
    checkOutputs(o);
  PreparedRun prepared = prepareRun(o);
  Window window(prepared.scene.name + " - vkpt", prepared.scene.width, prepared.scene.height);
  const gpu::Presentation presentation{
      window.instanceExtensions(), [&window](VkInstance instance) { return window.makeSurface(instance); }};
  const gpu::Context context({o.device, o.validation, pipelineCacheFolder(), presentation});
  return Session(options, prepared, context, window).run();
}

} // namespace

int main(int argc, char** argv) { return runProgram(argc, argv, run); }
