#pragma once
// What happens, as lines of JSON on stdout: for scripts that drive the preview.

#include "core/math.h"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace vkpt {

nlohmann::json numbers(Vec2i v);
nlohmann::json numbers(const Vec3d& v);

class EventLog {
public:
  explicit EventLog(bool on) : m_on(on) {}
  /// {"event": name, ...facts}
  void write(std::string_view name, const nlohmann::json& facts) const;

private:
  bool m_on;
};

} // namespace vkpt
