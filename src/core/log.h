#pragma once
// The log goes to stderr; stdout carries results.

namespace vkpt {

enum class LogLevel { Quiet, Normal, Verbose };

/// Makes spdlog's default logger write "vkpt: message" to stderr at the given level.
void setUpLog(LogLevel level);

} // namespace vkpt
