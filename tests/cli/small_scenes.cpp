#include "cli/small_scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

namespace vkpt::test {

std::string concentric(int count) {
  std::string obj;
  for (int i = 0; i < count; ++i) {
    const double r = 1.0 + i / static_cast<double>(count);
    fmt::format_to(std::back_inserter(obj), "v {} {} 0\nv {} {} 0\nv 0 {} 0\nf -3 -2 -1\n", -r, -r, r, -r, r);
  }
  return obj;
}

std::string identical(int count) {
  std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < count; ++i)
    obj += "f 1 2 3\n";
  return obj;
}

std::string atOnePoint(int count) {
  std::string obj = kSquare + "v .5 .5 .5\n";
  for (int i = 0; i < count; ++i)
    obj += "f 5 5 5\n";
  return obj;
}

std::string sliverFan(int count) {
  std::string obj = "v 0 0 0\n";
  for (int i = 0; i <= count; ++i) {
    const double phi = 2.0 * std::numbers::pi * i / count;
    fmt::format_to(std::back_inserter(obj), "v {} {} 0\n", std::cos(phi), std::sin(phi));
  }
  for (int i = 0; i < count; ++i)
    fmt::format_to(std::back_inserter(obj), "f 1 {} {}\n", i + 2, i + 3);
  return obj;
}

std::string waves(int n) {
  std::string obj;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      const double u = x / static_cast<double>(n);
      const double v = y / static_cast<double>(n);
      fmt::format_to(std::back_inserter(obj), "v {:.7g} {:.7g} {:.7g}\n", u, v,
                     0.1 * std::sin(20.0 * u) * std::cos(17.0 * v));
    }
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x + 1;
      fmt::format_to(std::back_inserter(obj), "f {} {} {} {}\n", a, a + 1, a + n + 2, a + n + 1);
    }
  }
  return obj;
}

} // namespace vkpt::test
