#pragma once
#include <chrono>

namespace vkpt {

/// Wall time since construction or the last restart, in seconds; monotonic.
class Stopwatch {
public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
  }
  /// Returns the seconds so far and starts again from zero.
  double restart() {
    const double s = seconds();
    m_start = std::chrono::steady_clock::now();
    return s;
  }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

} // namespace vkpt
