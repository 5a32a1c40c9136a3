#include "app/work_line.h"

#include "core/duration.h"

#include <fmt/format.h>

#include <numeric>

namespace vkpt {

WorkLine::WorkLine(bool visible, std::vector<double> plannedSeconds)
    : m_line(visible), m_planned(std::move(plannedSeconds)),
      m_all(std::accumulate(m_planned.begin(), m_planned.end(), 0.0)) {}

void WorkLine::tell(double share, const std::string& what) {
  if (!m_line.isDue())
    return;
  const double done = (m_done + share * m_planned.at(m_current)) / m_all;
  const std::string left =
      done > 0.0 ? durationText(m_clock.seconds() * (1.0 / done - 1.0)) + " left, " : std::string();
  m_line.draw(
      fmt::format("{:.0f} %, {}{} of {}: {}", done * 100.0, left, m_current + 1, m_planned.size(), what));
}

void WorkLine::next() { m_done += m_planned.at(m_current++); }

} // namespace vkpt
