#include "app/run_program.h"

#include "core/log.h"

#include <spdlog/spdlog.h>

#include <exception>
#include <new>

namespace vkpt {

int runProgram(int argc, char** argv, const std::function<ExitCode(const std::vector<std::string>&)>& run) {
  setUpLog(LogLevel::Normal);
  try {
    return static_cast<int>(run({argv + 1, argv + argc}));
  } catch (const Error& e) {
    spdlog::error("{}", e.what());
    return static_cast<int>(e.code());
  } catch (const std::bad_alloc&) {
    spdlog::error("out of memory; a smaller --size or scene may fit");
    return static_cast<int>(ExitCode::Scene);
  } catch (const std::exception& e) {
    spdlog::error("{}", e.what());
    return static_cast<int>(ExitCode::Device);
  }
}

} // namespace vkpt
