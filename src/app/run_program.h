#pragma once
#include "core/error.h"

#include <functional>
#include <string>
#include <vector>

namespace vkpt {

/// The body of a main(): sets the log up, runs, and turns what is thrown into one line and an exit code.
int runProgram(int argc, char** argv, const std::function<ExitCode(const std::vector<std::string>&)>& run);

} // namespace vkpt
