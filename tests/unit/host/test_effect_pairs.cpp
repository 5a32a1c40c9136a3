// Every set of two effects reads only what is packed for it: on the host, where sanitizers watch.

#include "host/reference.h"
#include "scenes/made_scenes.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

TEST(EffectPairs, ReadWhatIsPackedForThem) {
  const Scene scene = everything();
  const HostSettings settings{everyOption(), 8, 8, 1};
  for (const EffectInfo& a : allEffects()) {
    for (const EffectInfo& b : allEffects()) {
      if (b.effect < a.effect)
        continue;
      EffectSet pair = EffectSet::of(a.effect);
      pair.set(b.effect);
      const PackedScene packed = packScene(scene, settings.estimator, pair, 1);
      const HostRender r = renderHost32(packed, scene, pair, settings, 1);
      ASSERT_EQ(r.counters.faults(), 0U) << a.name << ", " << b.name;
    }
  }
}

} // namespace
} // namespace vkpt::test
