#include "device/light_tracing.h"

#include "device/effective_material.h"
#include "device/filter_table.h"
#include "device/light_table.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace vkpt {
namespace {

constexpr std::uint32_t kCaustics = (1U << shared::kKindCaustic) | (1U << shared::kKindIndirectCaustic);

bool isSpecular(BsdfType type) {
#define VKPT_IS_SPECULAR(Name, Type) type == BsdfType::Type ||
  return VKPT_SPECULAR_BSDFS(VKPT_IS_SPECULAR) false;
#undef VKPT_IS_SPECULAR
}

/// Of the materials that triangles use.
struct Surfaces {
  bool specular = false;
  bool other = false;
  bool absorbs = false;
};

Surfaces surfacesOf(const Scene& scene) {
  const std::vector<Material> materials = effectiveMaterials(scene);
  std::vector<bool> used(materials.size());
  for (const Triangle& t : scene.triangles)
    used[t.material] = true;
  Surfaces found;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const Material& m = materials[i];
    if (!used[i] || isNothing(m))
      continue;
    found.absorbs = found.absorbs || (transmits(m) && m.absorption != Vec3f(0.0F));
    if (scatters(m))
      (isSpecular(effectiveBsdf(m)) ? found.specular : found.other) = true;
  }
  return found;
}

double halfArea(const Box3d& box) {
  const Vec3d e = box.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

Box3d joined(Box3d a, const Box3d& b) {
  a.extend(b.lower);
  a.extend(b.upper);
  return a;
}

/// The two whose common box is larger than theirs by the least become one.
void joinTwo(std::vector<Box3d>& boxes) {
  std::size_t a = 0;
  std::size_t b = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const double more = halfArea(joined(boxes[i], boxes[j])) - halfArea(boxes[i]) - halfArea(boxes[j]);
      if (more < least) {
        least = more;
        a = i;
        b = j;
      }
    }
  }
  boxes[a] = joined(boxes[a], boxes[b]);
  boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(b));
}

} // namespace

std::vector<Box3d> specularBoxes(const Scene& scene, std::size_t most) {
  const std::vector<Material> materials = effectiveMaterials(scene);
  std::vector<Box3d> byMaterial(materials.size());
  for (const Triangle& t : scene.triangles) {
    const Material& m = materials[t.material];
    if (!isSpecular(effectiveBsdf(m)) || !scatters(m) || isNothing(m))
      continue;
    for (const std::uint32_t v : t.vertex)
      byMaterial[t.material].extend(Vec3d(scene.positions[v]));
  }
  std::erase_if(byMaterial, [](const Box3d& box) { return box.empty(); });
  while (byMaterial.size() > most)
    joinTwo(byMaterial);
  return byMaterial;
}

std::optional<LightTracingObstacle> lightTracingObstacle(const Scene& scene, const EstimatorSettings& e) {
  const auto impossible = [](std::string because) {
    return LightTracingObstacle{{std::move(because), {}}, true};
  };
  const auto useless = [](std::string because) {
    return LightTracingObstacle{{std::move(because), {}}, false};
  };
  if (e.lightTracing == LightTracing::Off)
    return useless("--light-tracing off");
  if (e.light == LightStrategy::Bsdf)
    return impossible("--light bsdf");
  if (e.splitDepth > 0)
    return impossible(fmt::format("--split {}", e.splitDepth));
  if (e.kindImages)
    return impossible("--output-paths");
  if (!isPixelBox(scene.filter))
    return impossible("a filter other than a box of one pixel");
  if (e.maxBounces < 2)
    return useless(fmt::format("--max-bounces {}: no caustics", e.maxBounces));
  if ((e.pathKinds & kCaustics) == 0)
    return useless("--paths without caustics");
  const Surfaces surfaces = surfacesOf(scene);
  if (surfaces.absorbs)
    return impossible("glass that absorbs");
  if (!surfaces.specular)
    return useless("no surface is specular");
  if (!surfaces.other)
    return useless("no surface scatters other than specularly");
  if (emissiveTriangles(scene).empty())
    return useless("no triangle emits");
  return std::nullopt;
}

std::optional<EffectReason> guidingObstacle(const Scene& scene, const EstimatorSettings& e) {
  if (e.guiding == Guiding::Off)
    return EffectReason{"--guiding off", {}};
  if (e.maxBounces < 3)
    return EffectReason{fmt::format("--max-bounces {}: no caustics behind specular surfaces", e.maxBounces),
                        {}};
  if (const auto obstacle = lightTracingObstacle(scene, e))
    return obstacle->reason;
  return std::nullopt;
}

} // namespace vkpt
