#include "device/effects.h"

#include "device/light_table.h"

#include <array>

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
  default:
    break;
  }
  return Effect::Diffuse;
}

bool isBlack(const Vec3f& v) { return v == Vec3f(0.0F); }

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
  for (const Triangle& t : scene.triangles) {
    const Material& m = scene.materials[t.material];
    // A diffuse surface that reflects nothing, such as a lamp, scatters nothing.
    if (m.bsdf != BsdfType::Diffuse || !isBlack(m.reflectance))
      set.set(effectOf(m.bsdf));
    if (t.normal[0] != kNoNormal)
      set.set(Effect::SmoothNormals);
  }
  const std::size_t lights = emissiveTriangles(scene).size();
  const bool scatters =
      set.has(Effect::Diffuse) || set.has(Effect::Mirror) || set.has(Effect::Glass) || set.has(Effect::Metal);
  set.set(Effect::AreaLights, lights > 0);
  set.set(Effect::LightSampling, lights > 0 && set.has(Effect::Diffuse) &&
                                     settings.light == LightStrategy::Nee && settings.maxBounces > 0);
  set.set(Effect::ManyLights, lights > 1 && set.has(Effect::LightSampling));
  set.set(Effect::Background, !isBlack(scene.background));
  set.set(Effect::BounceLimit, settings.maxBounces != kUnlimitedBounces);
  set.set(Effect::Roulette, scatters && settings.effectiveRouletteAfter() <= settings.maxBounces);
  return set;
}

} // namespace vkpt
