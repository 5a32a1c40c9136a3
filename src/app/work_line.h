#pragma once
#include "app/status_line.h"

#include <vector>

namespace vkpt {

/// The progress line of several pieces of work, each planned to take some seconds.
class WorkLine {
public:
  WorkLine(bool visible, std::vector<double> plannedSeconds);

  /// How much of the piece that is under way is done, from 0 to 1. Draws when it is time to.
  void tell(double share, const std::string& what);
  /// It is done; the next one begins.
  void next();

private:
  StatusLine m_line;
  std::vector<double> m_planned;
  std::size_t m_current = 0;
  double m_done = 0.0; ///< planned seconds of the finished ones
  double m_all = 0.0;
  Stopwatch m_clock;
};

} // namespace vkpt
