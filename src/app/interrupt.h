#pragma once

namespace vkpt {

/// While one lives, SIGINT and SIGTERM ask the run to finish its unit of work; a second signal ends the
/// process.
class InterruptGuard {
public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  [[nodiscard]] static bool requested();
};

} // namespace vkpt
