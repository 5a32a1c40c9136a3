// Durations in words.

#include "core/duration.h"

#include <gtest/gtest.h>

namespace vkpt {
namespace {

TEST(Duration, HasTheUnitThatSuitsIt) {
  EXPECT_EQ(durationText(0.0), "0 s");
  EXPECT_EQ(durationText(0.04), "0.04 s");
  EXPECT_EQ(durationText(41.3), "41 s");
  EXPECT_EQ(durationText(310.0), "5.2 min");
  EXPECT_EQ(durationText(7.5 * 3600.0), "7.5 h");
  EXPECT_EQ(durationText(12.0 * 86400.0), "12 days");
  EXPECT_EQ(durationText(2.5 * 365.25 * 86400.0), "2.5 years");
  EXPECT_EQ(durationText(1e12), "more than a century");
}

} // namespace
} // namespace vkpt
