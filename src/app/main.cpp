// The command: parses the options and hands over to one command. runRender() leads to the render loop.

#include "app/commands.h"

#include <spdlog/spdlog.h>

#include <exception>
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
  if (!arguments.empty() && arguments.front() == "selftest")
    return vkpt::runSelftest({arguments.begin() + 1, arguments.end()});
  const vkpt::CommandLine line = vkpt::parseCommandLine(arguments);
  vkpt::setUpLog(line.render.log);
  switch (line.command) {
  case Command::Render:
    return vkpt::runRender(line.render);
  case Command::Devices:
    return vkpt::runDevices(line.render);
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

int main(int argc, char** argv) {
  vkpt::setUpLog(vkpt::LogLevel::Normal);
  try {
    return static_cast<int>(run({argv + 1, argv + argc}));
  } catch (const vkpt::Error& e) {
    spdlog::error("{}", e.what());
    return static_cast<int>(e.code());
  } catch (const std::bad_alloc&) {
    spdlog::error("out of memory; a smaller --size or scene may fit");
    return static_cast<int>(vkpt::ExitCode::Scene);
  } catch (const std::exception& e) {
    spdlog::error("{}", e.what());
    return static_cast<int>(vkpt::ExitCode::Device);
  }
}
