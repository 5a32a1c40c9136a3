#pragma once
// What happens, as lines of JSON on stdout: for scripts that drive the preview.

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace vkpt {

class EventLog {
public:
  explicit EventLog(bool on) : m_on(on) {}
  /// {"event": name, ...facts}
  void write(std::string_view name, const nlohmann::json& facts) const;

private:
  bool m_on;
};

} // namespace vkpt
