#include "bsdf/material_cases.h"

#include "device/packed_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

const Vec3f kGoldEta(0.143F, 0.375F, 1.442F);
const Vec3f kGoldK(3.983F, 2.386F, 1.603F);
constexpr double kAngles[] = {0.0, 45.0, 89.0};

std::vector<MaterialCase> makeMaterialCases() {
  std::vector<MaterialCase> cases;
  cases.push_back({"diffuse", diffuse(Vec3f(0.8F, 0.5F, 0.2F))});
  for (const float n : {0.0F, 1.0F, 20.0F, 1e3F, 1e6F})
    cases.push_back({fmt::format("phong{:g}", n), phong(Vec3f(0.3F), Vec3f(0.2F, 0.4F, 0.6F), n)});
  cases.push_back({"phongOnlyLobe", phong(Vec3f(0.0F), Vec3f(0.9F), 20.0F)});
  for (const float alpha : {1e-3F, 0.05F, 0.3F, 1.0F}) {
    for (const auto d : {MicrofacetDistribution::Ggx, MicrofacetDistribution::Beckmann}) {
      const char* name = d == MicrofacetDistribution::Ggx ? "ggx" : "beckmann";
      cases.push_back({fmt::format("{}Metal{:g}", name, alpha), roughMetal(kGoldEta, kGoldK, alpha, d)});
      cases.push_back({fmt::format("{}Glass{:g}", name, alpha), roughGlass(1.5F, alpha, d)});
    }
  }
  for (const float alpha : {0.05F, 0.3F})
    cases.push_back({fmt::format("microfacet{:g}", alpha), microfacet(Vec3f(0.2F, 0.1F, 0.4F), alpha, 1.5F)});
  cases.push_back({"microfacetOnlyCoat", microfacet(Vec3f(0.0F), 0.1F, 1.5F)});
  return cases;
}

std::vector<Chart> chartsFor(const Material& m, const View& view) {
  const Vec3d wo = glm::normalize(Vec3d(view.wo));
  const Vec3d n = glm::normalize(Vec3d(view.n));
  const Vec3d mirrored = n * (2.0 * glm::dot(n, wo)) - wo;
  const double alpha = static_cast<double>(m.roughness);
  const double index = static_cast<double>(m.intIor / m.extIor);
  switch (m.bsdf) {
  case BsdfType::Phong:
    return {polarChart(mirrored, n, 1.0 / std::sqrt(1.0 + static_cast<double>(m.exponent)))};
  case BsdfType::Microfacet:
  case BsdfType::RoughConductor:
    return {reflectionChart(wo, n, alpha)};
  case BsdfType::RoughDielectric:
    return {reflectionChart(wo, n, alpha), refractionChart(wo, n, alpha, view.front ? index : 1.0 / index)};
  default:
    return {polarChart(n, n, 1.0)};
  }
}

/// Oblique to the axes, so that frames matter.
View viewAt(std::uint32_t material, double degrees, bool front) {
  const Vec3d n = glm::normalize(Vec3d(0.3, -0.5, 0.8));
  const Vec3d across = glm::normalize(glm::cross(n, Vec3d(0.2, 0.9, 0.1)));
  const double theta = degrees * std::numbers::pi / 180.0;
  return {material, Vec3f(n * std::cos(theta) + across * std::sin(theta)), Vec3f(n), front};
}

std::vector<BsdfCase> makeBsdfCases() {
  std::vector<BsdfCase> cases;
  const auto materials = materialCases();
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    for (const double degrees : kAngles) {
      for (const bool front : {true, false}) {
        if (!front && materials[i].material.bsdf != BsdfType::RoughDielectric)
          continue;
        const View view = viewAt(i, degrees, front);
        cases.push_back(
            {fmt::format("{} at {:g} degrees{}", materials[i].name, degrees, front ? "" : ", from behind"),
             view, chartsFor(materials[i].material, view)});
      }
    }
  }
  return cases;
}

} // namespace

std::span<const MaterialCase> materialCases() {
  static const std::vector<MaterialCase> cases = makeMaterialCases();
  return cases;
}

std::span<const BsdfCase> bsdfCases() {
  static const std::vector<BsdfCase> cases = makeBsdfCases();
  return cases;
}

Scene sceneOf(std::span<const MaterialCase> materials) {
  SceneBuilder builder;
  for (const MaterialCase& m : materials)
    builder.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, m.material);
  return builder.build();
}

EffectSet effectsOf(const Scene& scene) {
  EffectSet set = detectEffects(scene, {});
  for (const Effect e : {Effect::Roulette, Effect::BounceLimit})
    set.set(e, false);
  return set;
}

} // namespace vkpt::test
