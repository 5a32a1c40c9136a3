#pragma once
#include <string>

namespace vkpt {

/// Seconds, 0 or more, for people: "0.4 s", "41 s", "5.2 min", "3.1 h", "12 days", "2.5 years"; beyond a
/// century only that.
std::string durationText(double seconds);

} // namespace vkpt
