#include "render/dispatch_sizer.h"

#include <algorithm>

namespace vkpt {
namespace {
constexpr std::uint64_t kFirstUnits = 4096; // 1 to 10 ms on one core
constexpr std::uint64_t kGrowth = 4;        // at most, from one dispatch to the next
} // namespace

std::uint64_t DispatchSizer::next() const { return nextWithin(m_target); }

std::uint64_t DispatchSizer::nextWithin(double seconds) const {
  if (m_unitsPerSecond == 0.0)
    return kFirstUnits;
  const double planned = m_unitsPerSecond * std::clamp(seconds, 1e-3, m_target);
  const double bounded = std::min(planned, static_cast<double>(m_last * kGrowth));
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(bounded));
}

void DispatchSizer::measured(std::uint64_t units, double seconds) {
  const double rate = static_cast<double>(units) / std::max(seconds, 1e-6);
  m_unitsPerSecond = m_unitsPerSecond == 0.0 ? rate : 0.5 * (m_unitsPerSecond + rate);
  m_last = units;
}

} // namespace vkpt
