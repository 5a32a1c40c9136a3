// Which effects a scene calls for, and because of what: one walk over the scene yields both.

#include "device/effective_material.h"
#include "device/effects.h"
#include "device/enclosure.h"
#include "device/filter_table.h"
#include "device/light_table.h"
#include "device/light_tracing.h"
#include "device/light_tree.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <fmt/format.h>

namespace vkpt {
namespace {

#define VKPT_EFFECT(Name, Type) Effect::Name,
constexpr auto kSmoothBsdfs = {VKPT_SMOOTH_BSDFS(VKPT_EFFECT)};
constexpr auto kSpecularBsdfs = {VKPT_SPECULAR_BSDFS(VKPT_EFFECT)};
#undef VKPT_EFFECT
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

Effect effectOf(BsdfType type) { return static_cast<Effect>(type); }

bool isBlack(const Vec3f& v) { return v == Vec3f(0.0F); }
bool isLit(const Vec3f& v) { return v.x > 0.0F || v.y > 0.0F || v.z > 0.0F; }

std::string called(const Material& m) {
  return m.name.empty() ? "a material" : fmt::format("material '{}'", m.name);
}

class Detection {
public:
  Detection(const Scene& scene, const EstimatorSettings& settings)
      : m_scene(scene), m_settings(settings), m_materials(effectiveMaterials(scene)) {}

  EffectReasons run() {
    const bool goesOn = m_settings.maxBounces > 0;
    findUses();
    for (std::size_t i = 0; i < m_materials.size(); ++i)
      material(m_materials[i], m_scene.materials[i].texture, m_firstUse[i] != kNone, goesOn);
    if (goesOn)
      normals();
    emitters();
    outside();
    lightSampling(goesOn);
    paths();
    specularSamples();
    sharedPaths();
    caustics();
    guiding();
    image();
    for (const EffectInfo& e : allEffects()) {
      EffectReason& r = reason(e.effect);
      if (r.because.empty())
        r.because = fmt::format("needs {}", e.condition);
    }
    return std::move(m_out);
  }

private:
  EffectReason& reason(Effect e) { return m_out.byId[static_cast<std::size_t>(e)]; }
  [[nodiscard]] bool has(Effect e) const { return m_out.set.has(e); }
  [[nodiscard]] bool hasAny(std::initializer_list<Effect> effects) const {
    return std::ranges::any_of(effects, [this](Effect e) { return has(e); });
  }

  /// The first object to call for an effect is its reason.
  void on(Effect e, std::string because, const SourceLocation& where = {}) {
    if (has(e))
      return;
    m_out.set.set(e);
    reason(e) = {std::move(because), where};
  }
  /// Comes near to calling for it: the reason where nothing does.
  void miss(Effect e, std::string because, const SourceLocation& where = {}) {
    if (reason(e).because.empty())
      reason(e) = {std::move(because), where};
  }

  void findUses() {
    m_firstUse.assign(m_materials.size(), kNone);
    for (std::size_t i = 0; i < m_scene.triangles.size(); ++i) {
      std::size_t& first = m_firstUse[m_scene.triangles[i].material];
      if (first == kNone && triangleArea(m_scene, m_scene.triangles[i]) > 0.0)
        first = i;
    }
  }

  /// As it is in effect; `texture`: what the file gives it.
  void material(const Material& m, std::uint32_t texture, bool used, bool goesOn) {
    const Effect own = effectOf(m.bsdf);
    if (!used)
      return miss(own, called(m) + " is on no triangle that has an area", m.where);
    if (isNothing(m))
      return miss(own, called(m) + " has one index on both sides: its triangles are left out", m.where);
    const BsdfType type = effectiveBsdf(m);
    if (transmits(m) && !isBlack(m.absorption)) {
      on(Effect::Absorption, called(m), m.where);
      if (type == BsdfType::RoughDielectric)
        on(Effect::RoughGlass, called(m) + " absorbs", m.where);
    }
    if (!scatters(m))
      return miss(own, called(m) + " reflects nothing", m.where);
    if (!goesOn)
      return miss(own, "--max-bounces 0: no path goes on from " + called(m), m.where);
    on(effectOf(type), called(m), m.where);
    if (effectOf(type) != own)
      miss(own, fmt::format("{} has the effect of {}", called(m), effectName(effectOf(type))), m.where);
    if (!m.twoSided && !transmits(m))
      on(Effect::OneSided, called(m), m.where);
    if (hasFacets(m)) {
      const bool beckmann = m.distribution == MicrofacetDistribution::Beckmann;
      on(beckmann ? Effect::Beckmann : Effect::Ggx, called(m), m.where);
    }
    if (readsTexture(m))
      on(Effect::Textures, called(m), m.where);
    else if (m.texture != texture)
      miss(Effect::Textures, called(m) + " has a texture of one colour", m.where);
    else if (texture != kNoTexture)
      miss(Effect::Textures, called(m) + " has a texture and no use for it", m.where);
  }

  void normals() {
    for (const Triangle& t : m_scene.triangles) {
      const Material& m = m_materials[t.material];
      if (t.normal[0] == kNoNormal || !scatters(m) || isNothing(m))
        continue;
      if (!isFlat(m_scene, t))
        return on(Effect::SmoothNormals, "a triangle with " + called(m), m.where);
      miss(Effect::SmoothNormals, "the file's normals are those of the triangles, e.g. of " + called(m),
           m.where);
    }
  }

  void emitters() {
    if (const auto emitting = emissiveTriangles(m_scene); !emitting.empty()) {
      const Material& m = m_scene.materials[m_scene.triangles[emitting.front()].material];
      on(Effect::AreaLights, called(m), m.where);
    }
    for (const Material& m : m_scene.materials) {
      if (isLit(m.emission))
        miss(Effect::AreaLights, called(m) + " emits, but from no triangle that has an area", m.where);
    }
  }

  /// What shines from infinitely far.
  void outside() {
    const EnvironmentMap& map = m_scene.environment;
    const Vec3f& b = m_scene.background;
    if (map.width > 0 && !hasEnvironment(m_scene))
      miss(Effect::Environment, fmt::format("environment '{}' is black", map.file.string()), map.where);
    const bool any = hasEnvironment(m_scene) || !isBlack(b) || !m_scene.directionalLights.empty();
    if (const auto about = any ? enclosingMaterial(m_scene) : std::nullopt) {
      const Material& m = m_materials[*about];
      const std::string because = "nothing outside is seen: the camera is in a closed mesh with " + called(m);
      if (hasEnvironment(m_scene))
        miss(Effect::Environment, because, m.where);
      if (!isBlack(b))
        miss(Effect::Background, because, m.where);
      if (!m_scene.directionalLights.empty())
        miss(Effect::DeltaLights, because, m.where);
      return;
    }
    if (hasEnvironment(m_scene))
      on(Effect::Environment, fmt::format("environment '{}'", map.file.string()), map.where);
    if (!isBlack(b))
      on(Effect::Background, fmt::format("background {:g},{:g},{:g}", b.x, b.y, b.z));
  }

  EffectReason nameOf(const LightSource& light) const {
    switch (light.kind) {
    case LightSource::Kind::Triangle: {
      const Material& m = m_scene.materials[m_scene.triangles[light.index].material];
      return {called(m), m.where};
    }
    case LightSource::Kind::Point:
      return {"a point light", m_scene.pointLights[light.index].where};
    case LightSource::Kind::Directional:
      return {"a directional light", m_scene.directionalLights[light.index].where};
    case LightSource::Kind::Environment:
      break;
    }
    return {"the environment", m_scene.environment.where};
  }

  void lightSampling(bool goesOn) {
    const LightTable table = makeLightTable(m_scene, m_settings.light);
    for (const Effect e :
         {Effect::LightSampling, Effect::Mis, Effect::ManyLights, Effect::LightTree, Effect::LightSamples}) {
      if (!goesOn)
        miss(e, "--max-bounces 0: no path goes on from a surface");
      else if (!hasAny(kSmoothBsdfs))
        miss(e, "no surface scatters other than specularly");
      else if (table.lights.empty() && m_settings.light == LightStrategy::Bsdf)
        miss(e, "--light bsdf");
      else if (table.lights.empty())
        miss(e, "no light");
    }
    if (!goesOn || !hasAny(kSmoothBsdfs) || table.lights.empty())
      return;
    const EffectReason first = nameOf(table.lights.front());
    on(Effect::LightSampling, first.because, first.where);
    if (table.lights.size() > 1)
      on(Effect::ManyLights, fmt::format("{} lights, the first: {}", table.lights.size(), first.because),
         first.where);
    else
      miss(Effect::ManyLights, "one light needs no table", first.where);
    lightTree(table);
    for (const LightSource& light : table.lights) {
      const bool delta =
          light.kind == LightSource::Kind::Point || light.kind == LightSource::Kind::Directional;
      const EffectReason r = nameOf(light);
      if (delta)
        on(Effect::DeltaLights, r.because, r.where);
      else if (m_settings.light == LightStrategy::Mis)
        on(Effect::Mis, "--light mis, and " + r.because, r.where);
    }
    miss(Effect::Mis,
         m_settings.light == LightStrategy::Mis ? "no ray can hit a light" : "another --light than mis");
    if (m_settings.lightSamples > 1)
      on(Effect::LightSamples, fmt::format("--light-samples {}", m_settings.lightSamples));
  }

  void lightTree(const LightTable& table) {
    const std::size_t lights = table.lights.size();
    const bool asked = m_settings.lightSelection == LightSelection::Tree;
    if (choosesByTree(m_scene, m_settings, table))
      on(Effect::LightTree, asked ? "--light-selection tree" : fmt::format("{} lights, spread out", lights));
    else if (m_settings.lightSelection == LightSelection::Power)
      miss(Effect::LightTree, "--light-selection power");
    else if (lights < 2)
      miss(Effect::LightTree, "one light needs no tree");
    else
      miss(Effect::LightTree, fmt::format("{} lights that are few or in one small place", lights));
  }

  void paths() {
    const bool scattering = hasAny(kSmoothBsdfs) || hasAny(kSpecularBsdfs);
    const std::uint32_t limit = m_settings.maxBounces;
    if (scattering && limit != kUnlimitedBounces)
      on(Effect::BounceLimit, fmt::format("--max-bounces {}", limit));
    const std::uint32_t after = m_settings.effectiveRouletteAfter();
    if (scattering && after <= limit)
      on(Effect::Roulette, fmt::format("paths that go on beyond {} bounces", after));
    else if (scattering)
      miss(Effect::Roulette, fmt::format("--max-bounces {} ends every path before roulette", limit));
    for (const Effect e : kSpecularBsdfs) {
      if (!has(e))
        continue;
      const EffectReason because = reason(e);
      if (m_settings.splitDepth > 0)
        on(Effect::Splitting, fmt::format("--split {}, and {}", m_settings.splitDepth, because.because),
           because.where);
      else
        miss(Effect::Splitting, "--split 0");
    }
  }

  void specularSamples() {
    for (const Effect e : kSpecularBsdfs) {
      const EffectReason because = reason(e);
      if (has(e) && m_settings.specularSamples > 1)
        on(Effect::SpecularSamples,
           fmt::format("--specular-samples {}, and {}", m_settings.specularSamples, because.because),
           because.where);
      else if (has(e))
        miss(Effect::SpecularSamples, "--specular-samples 1");
    }
  }

  void sharedPaths() {
    if (m_settings.pathReuse <= 1)
      miss(Effect::PathReuse, "--path-reuse 1");
    else if (const auto obstacle = pathReuseObstacle(m_settings))
      miss(Effect::PathReuse, *obstacle);
    else if (m_settings.maxBounces < 2)
      miss(Effect::PathReuse, fmt::format("--max-bounces {}: no vertex to share", m_settings.maxBounces));
    else if (has(Effect::Diffuse))
      on(Effect::PathReuse,
         fmt::format("--path-reuse {}, and {}", m_settings.pathReuse, reason(Effect::Diffuse).because),
         reason(Effect::Diffuse).where);
  }

  void caustics() {
    const auto obstacle = lightTracingObstacle(m_scene, m_settings);
    if (obstacle)
      return miss(Effect::LightTracing, obstacle->reason.because, obstacle->reason.where);
    for (const Effect e : kSpecularBsdfs) {
      if (has(e))
        on(Effect::LightTracing, reason(e).because, reason(e).where);
    }
  }

  void guiding() {
    if (const auto obstacle = guidingObstacle(m_scene, m_settings))
      miss(Effect::Guiding, obstacle->because, obstacle->where);
    else if (has(Effect::Diffuse))
      on(Effect::Guiding, reason(Effect::LightTracing).because, reason(Effect::LightTracing).where);
  }

  void image() {
    if (m_settings.kindImages) {
      on(Effect::KindImages, "--output-paths");
      on(Effect::PathKinds, "--output-paths");
    }
    if (m_settings.pathKinds != kAllPathKinds)
      on(Effect::PathKinds, "--paths with fewer than all kinds");
    if (!isPixelBox(m_scene.filter))
      on(Effect::PixelFilter, fmt::format("a filter of radius {:g} pixels", m_scene.filter.radius));
    else
      miss(Effect::PixelFilter, "the filter is a box of one pixel");
  }

  const Scene& m_scene;
  const EstimatorSettings& m_settings;
  std::vector<Material> m_materials;   ///< as they are in effect
  std::vector<std::size_t> m_firstUse; ///< by material: a triangle that has an area, or kNone
  EffectReasons m_out;
};

} // namespace

bool isFlat(const Scene& scene, const Triangle& t) {
  constexpr double kLargestSine = 1e-5; // below what an image is compared to, above a file's six digits
  if (t.normal[0] == kNoNormal)
    return true;
  const Vec3d a = scene.positions[t.vertex[0]];
  const Vec3d across =
      glm::cross(Vec3d(scene.positions[t.vertex[1]]) - a, Vec3d(scene.positions[t.vertex[2]]) - a);
  if (across == Vec3d(0.0))
    return true; // nothing meets it
  const Vec3d n = glm::normalize(across);
  const bool along = glm::dot(n, Vec3d(scene.normals[t.normal[0]])) > 0.0;
  return std::ranges::all_of(t.normal, [&](std::uint32_t i) {
    const Vec3d ns = scene.normals[i];
    return (glm::dot(n, ns) > 0.0) == along && glm::length(glm::cross(n, ns)) < kLargestSine;
  });
}

EffectReasons explainEffects(const Scene& scene, const EstimatorSettings& settings) {
  return Detection(scene, settings).run();
}

} // namespace vkpt
