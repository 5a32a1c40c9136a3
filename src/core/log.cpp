#include "core/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace vkpt {

void setUpLog(LogLevel level) {
  auto logger =
      std::make_shared<spdlog::logger>("vkpt", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  logger->set_pattern("vkpt: %^%l%$: %v");
  logger->set_level(level == LogLevel::Quiet     ? spdlog::level::err
                    : level == LogLevel::Verbose ? spdlog::level::debug
                                                 : spdlog::level::info);
  spdlog::set_default_logger(std::move(logger));
}

} // namespace vkpt
