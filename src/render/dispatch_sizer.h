#pragma once
#include <cstdint>

namespace vkpt {

inline constexpr double kUnitSeconds = 0.075; ///< of a unit of work, where nothing asks for less

/// Chooses how much one dispatch does, by measured time: short enough that no device is ever held for long,
/// long enough that the cost of a dispatch does not matter.
class DispatchSizer {
public:
  explicit DispatchSizer(double targetSeconds = kUnitSeconds) : m_target(targetSeconds) {}

  /// Work units (samples) for the next dispatch; at least 1.
  [[nodiscard]] std::uint64_t next() const;
  /// Tells what the last dispatch took.
  void measured(std::uint64_t units, double seconds);
  /// Never plan beyond `seconds` (a time limit that draws near).
  [[nodiscard]] std::uint64_t nextWithin(double seconds) const;

private:
  double m_target;
  double m_unitsPerSecond = 0.0; ///< 0: nothing measured yet
  std::uint64_t m_last = 0;
};

} // namespace vkpt
