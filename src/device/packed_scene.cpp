#include "device/packed_scene.h"

#include "device/effective_material.h"
#include "device/light_table.h"
#include "device/light_tree.h"
#include "device/packed_light_node.h"
#include "shared/structs.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/packing.hpp>

namespace vkpt {
namespace {

// The traversal's bound (shaders/shared/structs.h) holds for the leaves that are built.
static_assert(shared::kLeafTriangles == kMaxLeafTriangles);
static_assert((shared::kStepBudget + 1 + 2 * shared::kMaxTraversalSteps) *
                      (1 + shared::kNodesPerStep + shared::kLeafTriangles) +
                  (shared::kMaxLightSamples + 1) * (shared::kMaxLightTreeDepth + 1) <
              65535);

Texel texel(const Vec3f& v, std::uint32_t w) {
  return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
          std::bit_cast<std::uint32_t>(v.z), w};
}
Texel texel(const Vec3f& v, float w) { return texel(v, std::bit_cast<std::uint32_t>(w)); }

/// Over the triangles that are something; the order is that of the scene's triangles.
Bvh buildOver(const Scene& scene, unsigned threads) {
  std::vector<std::uint32_t> kept;
  std::vector<Box3f> bounds;
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const Triangle& t = scene.triangles[i];
    if (isNothing(scene.materials[t.material]))
      continue;
    kept.push_back(i);
    Box3f& box = bounds.emplace_back();
    for (const std::uint32_t v : t.vertex)
      box.extend(scene.positions[v]);
  }
  BvhSettings settings;
  settings.threads = threads;
  settings.maxDepth = shared::kMaxStackDepth - 1U;
  Bvh bvh = buildBvh(bounds, settings);
  for (std::uint32_t& id : bvh.triangleOrder)
    id = kept[id];
  return bvh;
}

void packTriangles(const Scene& scene, bool smooth, PackedScene& packed) {
  for (const std::uint32_t id : packed.bvh.triangleOrder) {
    const Triangle& t = scene.triangles[id];
    packed.triangles.push_back(texel(scene.positions[t.vertex[0]], t.material));
    packed.triangles.push_back(texel(scene.positions[t.vertex[1]], id));
    packed.triangles.push_back(texel(scene.positions[t.vertex[2]], 0U));
    if (!smooth)
      continue;
    for (const std::uint32_t n : t.normal) {
      // A normal of 0 has no cosine with the viewer: the geometric normal stands in (surfaceAt).
      packed.normals.push_back(texel(n == kNoNormal ? Vec3f(0.0F) : scene.normals[n], 0U));
    }
  }
}

std::uint32_t flagsOf(const Material& m) {
  return (m.twoSided || transmits(m) ? 0U : shared::kMaterialOneSided) |
         (m.distribution == MicrofacetDistribution::Beckmann ? shared::kMaterialBeckmann : 0U);
}

void packMaterials(const Scene& scene, const std::vector<Material>& materials, const LightTable& lights,
                   PackedScene& packed) {
  std::vector<bool> sampled(scene.materials.size());
  for (const LightSource& light : lights.lights) {
    if (light.kind == LightSource::Kind::Triangle)
      sampled[scene.triangles[light.index].material] = true;
  }
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const Material& m = materials[i];
    const auto bsdf = effectiveBsdf(m);
    const double radiance = static_cast<double>(m.emission.x) + m.emission.y + m.emission.z;
    const double lightPdf = sampled[i] ? radiance / lights.totalPower : 0.0;
    packed.materials.push_back(texel(m.reflectance, static_cast<std::uint32_t>(bsdf) | (flagsOf(m) << 16U)));
    packed.materials.push_back(texel(m.emission, static_cast<float>(lightPdf)));
    packed.materials.push_back(texel(m.eta, bsdf == BsdfType::Phong ? m.exponent : m.roughness));
    packed.materials.push_back(texel(m.k, m.intIor / m.extIor));
    packed.materials.push_back(texel(m.specular, readsTexture(m) ? m.texture : kNoTexture));
    packed.materials.push_back(texel(m.absorption, 0U));
  }
}

void packLight(const Scene& scene, const LightSource& light, const AliasRow& row,
               std::span<const std::uint32_t> position, std::vector<Texel>& out) {
  std::array<Vec3f, 3> v{};
  Vec3f radiance(0.0F);
  std::uint32_t what = 0;
  switch (light.kind) {
  case LightSource::Kind::Triangle: {
    const Triangle& t = scene.triangles[light.index];
    v = {scene.positions[t.vertex[0]], scene.positions[t.vertex[1]], scene.positions[t.vertex[2]]};
    radiance = scene.materials[t.material].emission;
    what = position[light.index];
    break;
  }
  case LightSource::Kind::Point:
    v[0] = scene.pointLights[light.index].position;
    radiance = scene.pointLights[light.index].intensity;
    what = shared::kLightPoint;
    break;
  case LightSource::Kind::Directional:
    v[0] = -scene.directionalLights[light.index].direction;
    radiance = scene.directionalLights[light.index].irradiance;
    what = shared::kLightDirectional;
    break;
  case LightSource::Kind::Environment:
    what = shared::kLightEnvironment;
    break;
  }
  out.push_back(texel(v[0], static_cast<float>(row.threshold)));
  out.push_back(texel(v[1], row.alias));
  out.push_back(texel(v[2], static_cast<float>(light.probability)));
  out.push_back(texel(radiance, what));
}

void packLights(const Scene& scene, const LightTable& table, PackedScene& packed) {
  std::vector<std::uint32_t> position(scene.triangles.size());
  for (std::uint32_t i = 0; i < packed.bvh.triangleOrder.size(); ++i)
    position[packed.bvh.triangleOrder[i]] = i;
  for (std::size_t i = 0; i < table.lights.size(); ++i)
    packLight(scene, table.lights[i], table.rows[i], position, packed.lights);
}

/// After the triangles, which learn of their leaves.
void packLightTree(const Scene& scene, const LightTable& table, PackedScene& packed) {
  const LightTree tree = makeLightTree(scene, table);
  for (const LightTreeNode& node : tree.nodes)
    packLightNode(node, tree.smallestRadius, packed.lightNodes);
  for (std::uint32_t i = 0; i < table.lights.size(); ++i) {
    const std::uint32_t what = packed.lights[i * shared::kTexelsPerLight + 3][3];
    if (what == shared::kLightEnvironment)
      packed.lightChoice.environmentLeaf = tree.leafOfLight[i];
    else if (what < shared::kLightEnvironment)
      packed.triangles[std::size_t{what} * shared::kTexelsPerTriangle + 2][3] = tree.leafOfLight[i];
  }
}

void packUvs(const Scene& scene, PackedScene& packed) {
  for (const std::uint32_t id : packed.bvh.triangleOrder) {
    std::array<Vec2f, 3> uv{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t index = scene.triangles[id].uv[i];
      uv[i] = index == kNoUv ? Vec2f(0.0F) : scene.uvs[index];
    }
    packed.uvs.push_back(texel({uv[0].x, uv[0].y, uv[1].x}, uv[1].y));
    packed.uvs.push_back(texel({uv[2].x, uv[2].y, 0.0F}, 0U));
  }
}

/// By texture: whether a surface reads it.
std::vector<bool> texturesRead(const Scene& scene, const std::vector<Material>& materials) {
  std::vector<bool> read(scene.textures.size());
  for (const Triangle& t : scene.triangles) {
    const Material& m = materials[t.material];
    if (readsTexture(m))
      read[m.texture] = true;
  }
  return read;
}

/// Two pixels a texel: (r g, b 0) in half floats each. A texture that is not read has no pixels.
void packTextures(const Scene& scene, const std::vector<Material>& materials, PackedScene& packed) {
  using shared::kPixelsPerTexel;
  const std::vector<bool> read = texturesRead(scene, materials);
  std::size_t first = scene.textures.size() * kPixelsPerTexel;
  for (std::size_t i = 0; i < scene.textures.size(); ++i) {
    const Texture& t = scene.textures[i];
    packed.textures.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(t.width),
                               static_cast<std::uint32_t>(t.height), 0U});
    if (read[i])
      first += t.texels.size() + t.texels.size() % kPixelsPerTexel;
  }
  for (std::size_t texture = 0; texture < scene.textures.size(); ++texture) {
    const Texture& t = scene.textures[texture];
    if (!read[texture])
      continue;
    for (std::size_t i = 0; i < t.texels.size(); ++i) {
      if (i % kPixelsPerTexel == 0)
        packed.textures.push_back({});
      const std::size_t half = 2 * (i % kPixelsPerTexel);
      packed.textures.back()[half] = glm::packHalf2x16({t.texels[i].x, t.texels[i].y});
      packed.textures.back()[half + 1] = glm::packHalf2x16({t.texels[i].z, 0.0F});
    }
  }
}

void packEnvironment(const EnvironmentMap& map, PackedScene& packed) {
  const auto angles = texelSolidAngles(map.width, map.height);
  std::vector<double> weights;
  double total = 0.0;
  for (std::size_t i = 0; i < map.radiance.size(); ++i) {
    const Vec3d L = map.radiance[i];
    weights.push_back((L.x + L.y + L.z) * angles[i / static_cast<std::size_t>(map.width)]);
    total += weights.back();
  }
  const auto rows = makeAliasTable(weights);
  for (std::size_t i = 0; i < map.radiance.size(); ++i) {
    const Vec3d L = map.radiance[i];
    packed.environment.push_back(texel(map.radiance[i], static_cast<float>((L.x + L.y + L.z) / total)));
    packed.environment.push_back(
        {std::bit_cast<std::uint32_t>(static_cast<float>(rows[i].threshold)), rows[i].alias, 0U, 0U});
  }
}

/// A buffer that no code reads is still bound, and one that is read for nothing holds a whole record.
void fillEmpty(PackedScene& packed) {
  const auto fill = [](auto& texels, std::uint32_t record) {
    if (texels.empty())
      texels.resize(record);
  };
  fill(packed.triangles, shared::kTexelsPerTriangle);
  fill(packed.normals, shared::kTexelsPerTriangle);
  fill(packed.materials, shared::kTexelsPerMaterial);
  fill(packed.lights, shared::kTexelsPerLight);
  fill(packed.lightNodes, shared::kTexelsPerLightNode);
  fill(packed.uvs, shared::kTexelsPerUv);
  fill(packed.textures, 1);
  fill(packed.environment, shared::kTexelsPerEnvironmentTexel);
  fill(packed.guide, sizeof(Texel) / sizeof(std::uint32_t)); // single numbers
  fill(packed.lightGrid, sizeof(Texel) / sizeof(std::uint32_t));
}

} // namespace

PackedScene packScene(const Scene& scene, const EstimatorSettings& estimator, const EffectSet& effects,
                      unsigned threads) {
  return packScene(scene, estimator, effects, buildOver(scene, threads));
}

PackedScene packScene(const Scene& scene, const EstimatorSettings& estimator, const EffectSet& effects,
                      Bvh bvh) {
  PackedScene packed;
  packed.bvh = std::move(bvh);
  packed.leftOut = scene.triangles.size() - packed.bvh.triangleOrder.size();
  packTriangles(scene, effects.has(Effect::SmoothNormals), packed);
  const LightTable lights = makeLightTable(scene, estimator.light);
  const std::vector<Material> materials = effectiveMaterials(scene);
  packMaterials(scene, materials, lights, packed);
  packed.lightChoice.count = static_cast<std::uint32_t>(lights.lights.size());
  packed.lightChoice.environmentProbability = static_cast<float>(lights.environmentProbability());
  packed.lightChoice.totalPower = lights.totalPower;
  if (effects.has(Effect::LightSampling))
    packLights(scene, lights, packed);
  packed.lightChoice.byTree = effects.has(Effect::LightSampling) && effects.has(Effect::LightTree) &&
                              choosesByTree(scene, estimator, lights);
  if (packed.lightChoice.byTree)
    packLightTree(scene, lights, packed);
  if (effects.has(Effect::Textures) && !scene.textures.empty()) {
    packUvs(scene, packed);
    packTextures(scene, materials, packed);
  }
  if (effects.has(Effect::Environment) && hasEnvironment(scene))
    packEnvironment(scene.environment, packed);
  fillEmpty(packed);
  return packed;
}

PackedScene packScene(const Scene& scene, const EstimatorSettings& estimator, unsigned threads) {
  return packScene(scene, estimator, detectEffects(scene, estimator), threads);
}

} // namespace vkpt
