#include "device/effective_material.h"

#include "scene/limits.h"

#include <algorithm>
#include <cmath>

namespace vkpt {

BsdfType effectiveBsdf(const Material& m) {
  constexpr auto kLeast = static_cast<float>(kLeastRoughness);
  const bool coated = m.bsdf == BsdfType::Phong || m.bsdf == BsdfType::Microfacet;
  if (coated && m.specular == Vec3f(0.0F))
    return BsdfType::Diffuse;
  if (m.bsdf == BsdfType::Mirror && m.reflectance == Vec3f(0.0F))
    return BsdfType::Diffuse;
  if (m.bsdf == BsdfType::RoughConductor && m.roughness < kLeast)
    return BsdfType::Conductor;
  // Refraction's lobe is narrower by the difference of the indices.
  const float bend = std::min(1.0F, std::abs(m.intIor / m.extIor - 1.0F));
  if (m.bsdf == BsdfType::RoughDielectric && m.roughness * bend < kLeast)
    return BsdfType::Dielectric;
  return m.bsdf;
}

bool transmits(const Material& m) {
  return m.bsdf == BsdfType::Dielectric || m.bsdf == BsdfType::RoughDielectric;
}

bool hasFacets(const Material& m) {
  const BsdfType type = effectiveBsdf(m);
  return type == BsdfType::RoughConductor || type == BsdfType::RoughDielectric;
}

bool isNothing(const Material& m) {
  return transmits(m) && m.intIor == m.extIor && m.absorption == Vec3f(0.0F) && m.emission == Vec3f(0.0F);
}

bool readsTexture(const Material& m) {
  const BsdfType type = effectiveBsdf(m);
  const bool hasReflectance = type == BsdfType::Diffuse || type == BsdfType::Mirror ||
                              type == BsdfType::Phong || type == BsdfType::Microfacet;
  return m.texture != kNoTexture && hasReflectance && m.reflectance != Vec3f(0.0F);
}

bool scatters(const Material& m) {
  return effectiveBsdf(m) != BsdfType::Diffuse || m.reflectance != Vec3f(0.0F);
}

std::vector<Material> effectiveMaterials(const Scene& scene) {
  std::vector<Material> materials = scene.materials;
  for (Material& m : materials) {
    if (!readsTexture(m))
      continue;
    const std::vector<Vec3f>& texels = scene.textures[m.texture].texels;
    const Vec3f first = texels.front();
    if (!std::ranges::all_of(texels, [&first](const Vec3f& t) { return t == first; }))
      continue;
    m.reflectance *= first;
    m.texture = kNoTexture;
  }
  return materials;
}

} // namespace vkpt
