#include "device/effects.h"

#include "device/device_scene.h"
#include "device/filter_table.h"
#include "device/light_table.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace vkpt {
namespace {

constexpr auto kEffects = std::to_array<EffectInfo>({
#define VKPT_ROW(id, Name, name, what) {Effect::Name, #name, what},
    VKPT_EFFECTS(VKPT_ROW)
#undef VKPT_ROW
});

Effect effectOf(BsdfType type) {
  switch (type) {
  case BsdfType::Diffuse:
    return Effect::Diffuse;
  case BsdfType::Mirror:
    return Effect::Mirror;
  case BsdfType::Dielectric:
    return Effect::Glass;
  case BsdfType::Conductor:
    return Effect::Metal;
  case BsdfType::Phong:
    return Effect::Phong;
  case BsdfType::Microfacet:
    return Effect::Microfacet;
  case BsdfType::RoughConductor:
    return Effect::RoughMetal;
  case BsdfType::RoughDielectric:
    return Effect::RoughGlass;
  }
  return Effect::Diffuse;
}

constexpr auto kSmoothBsdfs = {Effect::Diffuse, Effect::Phong, Effect::Microfacet, Effect::RoughMetal,
                               Effect::RoughGlass};
constexpr auto kSpecularBsdfs = {Effect::Mirror, Effect::Glass, Effect::Metal};

bool any(const EffectSet& set, std::initializer_list<Effect> effects) {
  return std::ranges::any_of(effects, [&](Effect e) { return set.has(e); });
}

bool isBlack(const Vec3f& v) { return v == Vec3f(0.0F); }

void detectSurfaces(const Scene& scene, EffectSet& set) {
  for (const Triangle& t : scene.triangles) {
    const Material& m = scene.materials[t.material];
    if (t.normal[0] != kNoNormal)
      set.set(Effect::SmoothNormals);
    if (!scatters(m))
      continue;
    set.set(effectOf(effectiveBsdf(m)));
    const bool transmits = m.bsdf == BsdfType::Dielectric || m.bsdf == BsdfType::RoughDielectric;
    if (!m.twoSided && !transmits)
      set.set(Effect::OneSided);
    if (m.texture != kNoTexture)
      set.set(Effect::Textures);
    if (transmits && !isBlack(m.absorption))
      set.set(Effect::Absorption);
  }
}

void detectLights(const Scene& scene, const EstimatorSettings& settings, EffectSet& set) {
  const LightTable table = makeLightTable(scene, settings.light);
  const auto is = [](LightSource::Kind kind) {
    return [kind](const LightSource& light) { return light.kind == kind; };
  };
  const bool delta = std::ranges::any_of(table.lights, is(LightSource::Kind::Point)) ||
                     std::ranges::any_of(table.lights, is(LightSource::Kind::Directional));
  const bool sampling = !table.lights.empty() && any(set, kSmoothBsdfs) && settings.maxBounces > 0;
  const bool hittable = std::ranges::any_of(table.lights, is(LightSource::Kind::Triangle)) ||
                        std::ranges::any_of(table.lights, is(LightSource::Kind::Environment));
  set.set(Effect::AreaLights, !emissiveTriangles(scene).empty());
  set.set(Effect::Environment, hasEnvironment(scene));
  set.set(Effect::Background, !isBlack(scene.background));
  set.set(Effect::LightSampling, sampling);
  set.set(Effect::ManyLights, sampling && table.lights.size() > 1);
  set.set(Effect::DeltaLights, sampling && delta);
  set.set(Effect::Mis, sampling && hittable && settings.light == LightStrategy::Mis);
  set.set(Effect::LightSamples, sampling && settings.lightSamples > 1);
}

} // namespace

std::span<const EffectInfo> allEffects() { return kEffects; }

std::vector<std::string> EffectSet::names() const {
  std::vector<std::string> names;
  for (const auto& e : kEffects) {
    if (has(e.effect))
      names.emplace_back(e.name);
  }
  return names;
}

EffectSet detectEffects(const Scene& scene, const EstimatorSettings& settings) {
  EffectSet set;
  detectSurfaces(scene, set);
  detectLights(scene, settings, set);
  const bool scattering = any(set, kSmoothBsdfs) || any(set, kSpecularBsdfs);
  set.set(Effect::BounceLimit, settings.maxBounces != kUnlimitedBounces);
  set.set(Effect::Roulette, scattering && settings.effectiveRouletteAfter() <= settings.maxBounces);
  set.set(Effect::Splitting, settings.splitDepth > 0 && any(set, kSpecularBsdfs));
  set.set(Effect::KindImages, settings.kindImages);
  set.set(Effect::PathKinds, settings.kindImages || settings.pathKinds != kAllPathKinds);
  set.set(Effect::PixelFilter, !isPixelBox(scene.filter));
  return set;
}

} // namespace vkpt
