// The device's compiler takes every effect alone and every two of them together, and what it makes of them
// runs.
#include "effects/effect_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

std::string namesOf(const EffectSet& set) { return fmt::format("{}", fmt::join(set.names(), ", ")); }

TEST(Combinations, EveryEffectAlone) {
  for (const EffectInfo& e : allEffects())
    EXPECT_EQ(tryKernel(EffectSet::of(e.effect)), "") << e.name;
}

TEST(Combinations, EveryTwoEffects) {
  for (const EffectSet& set : pairwiseSets())
    EXPECT_EQ(tryKernel(set), "") << namesOf(set);
}

/// That the sets are what they are said to be.
TEST(Combinations, HaveEveryTwoEffectsInEveryWay) {
  const std::vector<EffectSet> sets = pairwiseSets();
  for (const EffectInfo& a : allEffects()) {
    for (const EffectInfo& b : allEffects()) {
      if (a.effect == b.effect)
        continue;
      unsigned found = 0;
      for (const EffectSet& set : sets)
        found |= 1U << ((set.has(a.effect) ? 2U : 0U) + (set.has(b.effect) ? 1U : 0U));
      EXPECT_EQ(found, 15U) << a.name << " and " << b.name;
    }
  }
}

} // namespace
} // namespace vkpt::test
