// The command: parses the options and hands over to one command. runRender() leads to the render loop.

#include "app/commands.h"
#include "app/run_program.h"

#include <string>
#include <vector>

namespace {

vkpt::ExitCode run(const std::vector<std::string>& arguments) {
  using vkpt::Command;
  if (!arguments.empty() && arguments.front() == "compare")
    return vkpt::runCompare({arguments.begin() + 1, arguments.end()});
  if (!arguments.empty() && arguments.front() == "assignment")
    return vkpt::runAssignment({arguments.begin() + 1, arguments.end()});
  if (!arguments.empty() && arguments.front() == "study")
    return vkpt::runStudy({arguments.begin() + 1, arguments.end()});
  if (!arguments.empty() && arguments.front() == "view")
    return vkpt::runView({arguments.begin() + 1, arguments.end()});
  const vkpt::CommandLine line = vkpt::parseCommandLine(arguments);
  vkpt::setUpLog(line.render.log);
  switch (line.command) {
  case Command::Render:
    return vkpt::runRender(line.render);
  case Command::Devices:
    return vkpt::runDevices(line.render);
  case Command::Selftest:
    return vkpt::runSelftest(line.render);
  case Command::Replay:
    return vkpt::runReplay(line.render);
  case Command::Explain:
    return vkpt::runExplain(line.render);
  case Command::ListScenes:
    return vkpt::runListScenes();
  case Command::Exit:
    return vkpt::ExitCode::Done;
  }
  return vkpt::ExitCode::Done;
}

} // namespace

int main(int argc, char** argv) { return vkpt::runProgram(argc, argv, run); }
