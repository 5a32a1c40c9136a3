#include "effects/effect_sets.h"

#include "scenes/made_scenes.h"
#include "scenes/render_fixture.h"

#include <fmt/format.h>

#include <bit>

namespace vkpt::test {
namespace {

double choices(int n, int k) {
  double product = 1.0;
  for (int i = 0; i < k; ++i)
    product = product * (n - i) / (i + 1);
  return product;
}

} // namespace

std::vector<EffectSet> pairwiseSets() {
  const std::size_t effects = allEffects().size();
  int bits = 2;
  while (choices(bits, bits / 2 + 1) < static_cast<double>(effects))
    ++bits;
  std::vector<EffectSet> sets(static_cast<std::size_t>(bits) + 1); // and the empty one
  std::size_t next = 0;
  for (std::uint32_t word = 0; next < effects; ++word) {
    if (std::popcount(word) != bits / 2 + 1)
      continue;
    for (std::size_t i = 0; i < static_cast<std::size_t>(bits); ++i)
      sets[i].set(allEffects()[next].effect, ((word >> i) & 1U) != 0U);
    ++next;
  }
  return sets;
}

std::string tryKernel(const EffectSet& effects) {
  static const Scene scene = everything();
  RenderSetup setup{.estimator = everyOption(), .width = 8, .height = 8, .frames = 1, .seed = 1};
  setup.effects = effects;
  const std::uint64_t before = sharedContext().validationMessages();
  const Rendered r = renderScene(scene, setup);
  if (sharedContext().validationMessages() != before)
    return "the validation layer spoke; see above";
  if (r.counters.faults() > 0)
    return fmt::format("{} faults", r.counters.faults());
  return {};
}

} // namespace vkpt::test
