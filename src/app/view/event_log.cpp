#include "app/view/event_log.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <string>

namespace vkpt {

nlohmann::json numbers(Vec2i v) { return {v.x, v.y}; }
nlohmann::json numbers(const Vec3d& v) { return {v.x, v.y, v.z}; }

void EventLog::write(std::string_view name, const nlohmann::json& facts) const {
  if (!m_on)
    return;
  nlohmann::json line = facts;
  line["event"] = std::string(name);
  fmt::print("{}\n", line.dump());
  std::fflush(stdout);
}

} // namespace vkpt
