#include "core/duration.h"

#include <fmt/format.h>

#include <array>

namespace vkpt {

std::string durationText(double seconds) {
  struct Unit {
    const char* name;
    double seconds;
    double most; // of it, before the next one is taken
  };
  constexpr double kDay = 86400.0, kYear = 365.25 * kDay;
  constexpr std::array<Unit, 5> kUnits{{{"s", 1.0, 100.0},
                                        {"min", 60.0, 100.0},
                                        {"h", 3600.0, 48.0},
                                        {"days", kDay, 400.0},
                                        {"years", kYear, 100.0}}};
  for (const Unit& unit : kUnits) {
    const double value = seconds / unit.seconds;
    if (value < unit.most)
      return fmt::format("{:.2g} {}", value, unit.name);
  }
  return "more than a century";
}

} // namespace vkpt
