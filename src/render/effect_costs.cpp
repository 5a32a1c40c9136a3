#include "render/effect_costs.h"

#include "render/render_loop.h"

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

/// A value with so much of the sorted sample below it.
double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

class Variant {
public:
  Variant(const gpu::Context& context, const DeviceScene& packed, const Scene& scene,
          const EffectSet& effects, const IntegratorSettings& settings)
      : m_integrator(context, packed, scene, effects, settings) {
    m_integrator.warmUp();
  }

  double seconds(std::uint64_t frames) {
    RenderJob job;
    job.frames = frames;
    RenderObserver observer;
    Film film;
    m_integrator.clear();
    return renderUntil(m_integrator, film, job, observer).seconds;
  }

  double nanosecondsPerRay(std::uint64_t frames) {
    const std::uint64_t before = m_integrator.counters().raysClosest;
    const double taken = seconds(frames);
    return 1e9 * taken / static_cast<double>(m_integrator.counters().raysClosest - before);
  }

private:
  Integrator m_integrator;
};

EffectCost compare(Effect effect, bool isOn, Variant& set, Variant& other, std::uint64_t frames, int turns) {
  std::vector<double> with;
  std::vector<double> without;
  std::vector<double> ratios;
  for (int turn = 0; turn < turns; ++turn) {
    const double own = set.nanosecondsPerRay(frames);
    const double others = other.nanosecondsPerRay(frames);
    with.push_back(isOn ? own : others);
    without.push_back(isOn ? others : own);
    ratios.push_back(with.back() / without.back());
  }
  constexpr double kHalf = 0.5;
  constexpr double kQuarter = 0.25;
  return {effect,
          quantile(with, kHalf),
          quantile(without, kHalf),
          quantile(ratios, kHalf),
          kHalf * (quantile(ratios, 1.0 - kQuarter) - quantile(ratios, kQuarter)),
          !isOn};
}

} // namespace

std::vector<EffectCost> measureEffectCosts(const gpu::Context& context, const Scene& scene,
                                           const PackedScene& packed, const EstimatorSettings& estimator,
                                           const EffectSet& effects, const CostSettings& settings,
                                           const std::function<void(const EffectCost&)>& onMeasured) {
  const DeviceScene device = uploadScene(context, packed);
  IntegratorSettings integrator;
  integrator.estimator = estimator;
  integrator.width = settings.edge;
  integrator.height = settings.edge;
  Variant set(context, device, scene, effects, integrator);
  const double group = set.seconds(shared::kSamplesPerGroup);
  const auto groups = static_cast<std::uint64_t>(std::ceil(std::max(1.0, settings.seconds / group)));
  const std::uint64_t frames = groups * shared::kSamplesPerGroup;
  std::vector<EffectCost> costs;
  for (const EffectInfo& e : allEffects()) {
    const bool isOn = effects.has(e.effect);
    if (isOn && (e.effect == Effect::Roulette || e.effect == Effect::BounceLimit))
      continue;
    EffectSet changed = effects;
    changed.set(e.effect, !isOn);
    if (isOn)
      changed = without(effects, EffectSet::of(e.effect));
    Variant other(context, device, scene, changed, integrator);
    costs.push_back(compare(e.effect, isOn, set, other, frames, settings.turns));
    onMeasured(costs.back());
  }
  return costs;
}

} // namespace vkpt
