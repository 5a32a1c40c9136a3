#pragma once
// Random numbers of the host tests. Literals here carry suffixes: some of the tests are compiled with plain
// literals as float.

#include "core/hash.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace vkpt::test {

/// Seeded with a hash of the running test's name.
class Random {
public:
  Random() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    m_engine.seed(hashText(std::string(info->test_suite_name()) + "." + info->name()));
  }
  std::uint32_t bits() { return static_cast<std::uint32_t>(m_engine() >> 32U); }
  /// In [0, 1).
  double unit() { return static_cast<double>(m_engine() >> 11U) * static_cast<double>(0x1p-53L); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  template<class Vec3>
  Vec3 direction() {
    for (;;) { // a point of the unit ball, by rejection
      const double x = between(-1, 1);
      const double y = between(-1, 1);
      const double z = between(-1, 1);
      const double r2 = x * x + y * y + z * z;
      if (r2 > 1 || r2 < static_cast<double>(1e-4L))
        continue;
      const double r = std::sqrt(r2);
      using T = typename Vec3::value_type;
      return Vec3(T(x / r), T(y / r), T(z / r));
    }
  }
  template<class Vec3>
  Vec3 inCube(double half = 1) {
    using T = typename Vec3::value_type;
    const double x = between(-half, half);
    const double y = between(-half, half);
    const double z = between(-half, half);
    return Vec3(T(x), T(y), T(z));
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace vkpt::test
