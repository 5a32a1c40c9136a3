#include "device/effects.h"

#include <algorithm>

#include <fmt/format.h>

namespace vkpt {
namespace {

constexpr auto kEffects = std::to_array<EffectInfo>({
#define VKPT_ROW(id, Name, name, what) {Effect::Name, #name, what},
    VKPT_EFFECTS(VKPT_ROW)
#undef VKPT_ROW
});
static_assert(std::ranges::all_of(kEffects, [](const EffectInfo& e) {
  return static_cast<std::size_t>(e.effect) < kEffectIds;
}));

/// An effect that means nothing without one of the others.
struct Dependence {
  Effect effect;
  std::array<Effect, 2> on;
};
constexpr Dependence kDependences[] = {
    {Effect::Mis, {Effect::LightSampling, Effect::LightSampling}},
    {Effect::ManyLights, {Effect::LightSampling, Effect::LightSampling}},
    {Effect::LightTree, {Effect::ManyLights, Effect::ManyLights}},
    {Effect::DeltaLights, {Effect::LightSampling, Effect::LightSampling}},
    {Effect::LightSamples, {Effect::LightSampling, Effect::LightSampling}},
    {Effect::LightTracing, {Effect::LightSampling, Effect::LightSampling}},
    {Effect::RoughMetal, {Effect::Ggx, Effect::Beckmann}},
    {Effect::RoughGlass, {Effect::Ggx, Effect::Beckmann}},
};

} // namespace

std::span<const EffectInfo> allEffects() { return kEffects; }

std::string_view effectName(Effect effect) {
  return std::ranges::find(kEffects, effect, &EffectInfo::effect)->name;
}

EffectSet EffectSet::all() {
  EffectSet set;
  for (const auto& e : kEffects)
    set.set(e.effect);
  return set;
}

std::vector<std::string> EffectSet::names() const {
  std::vector<std::string> names;
  for (const auto& e : kEffects) {
    if (has(e.effect))
      names.emplace_back(e.name);
  }
  return names;
}

EffectSet without(const EffectSet& set, const EffectSet& leftOut) {
  EffectSet rest = set;
  for (const auto& e : kEffects) {
    if (leftOut.has(e.effect))
      rest.set(e.effect, false);
  }
  for (const auto& [effect, on] : kDependences) {
    const auto stays = [&rest](Effect e) { return rest.has(e); };
    if (std::ranges::none_of(on, stays))
      rest.set(effect, false);
  }
  return rest;
}

std::string EffectReason::text() const {
  return where.file.empty() ? because : fmt::format("{} ({})", because, where.text());
}

std::optional<std::string> pathReuseObstacle(const EstimatorSettings& settings) {
  if (settings.pathReuse <= 1)
    return std::nullopt;
  if (settings.splitDepth > 0)
    return fmt::format("--split {}", settings.splitDepth);
  if (settings.kindImages)
    return "--output-paths: a shared path has another kind for every pixel";
  return std::nullopt;
}

EffectSet detectEffects(const Scene& scene, const EstimatorSettings& settings) {
  return explainEffects(scene, settings).set;
}

} // namespace vkpt
