#pragma once
// What the commands share in reading their options with CLI11.

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace vkpt {

/// An option whose value `handle` parses. `kind` names the value in the help.
CLI::Option* addValue(CLI::App& app, const std::string& name, const char* kind,
                      const std::function<void(const std::string&)>& handle, const std::string& description);

/// False where help or the version was asked for, and printed. `help` is the command that tells the options.
/// Throws UsageError: one line that names the option, what is wrong, and what would be right.
bool parseArguments(CLI::App& app, const std::vector<std::string>& arguments, const std::string& help);

} // namespace vkpt
