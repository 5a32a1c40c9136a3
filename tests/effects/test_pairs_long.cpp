// Every two effects with nothing else: 378 kernels.
#include "effects/effect_sets.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

TEST(PairsAlone, CompileAndRun) {
  for (const EffectInfo& a : allEffects()) {
    for (const EffectInfo& b : allEffects()) {
      EffectSet pair = EffectSet::of(a.effect);
      pair.set(b.effect);
      if (a.effect < b.effect) {
        EXPECT_EQ(tryKernel(pair), "") << a.name << ", " << b.name;
      }
    }
  }
}

} // namespace
} // namespace vkpt::test
