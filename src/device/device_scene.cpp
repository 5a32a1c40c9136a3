#include "device/device_scene.h"

#include "device/light_table.h"
#include "shared/structs.h"

#include <algorithm>
#include <bit>

namespace vkpt {
namespace {

// The traversal's bound (shaders/shared/structs.h) holds for the leaves that are built.
static_assert(shared::kLeafTriangles == kMaxLeafTriangles);
static_assert((shared::kStepBudget + 1 + 2 * shared::kMaxTraversalSteps) *
                  (1 + shared::kNodesPerStep + shared::kLeafTriangles) <
              65535);

Texel texel(const Vec3f& v, std::uint32_t w) {
  return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
          std::bit_cast<std::uint32_t>(v.z), w};
}
Texel texel(const Vec3f& v, float w) { return texel(v, std::bit_cast<std::uint32_t>(w)); }

std::vector<Box3f> triangleBounds(const Scene& scene) {
  std::vector<Box3f> bounds(scene.triangles.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    for (const std::uint32_t v : scene.triangles[i].vertex)
      bounds[i].extend(scene.positions[v]);
  }
  return bounds;
}

void packTriangles(const Scene& scene, PackedScene& packed) {
  const bool smooth =
      std::ranges::any_of(scene.triangles, [](const Triangle& t) { return t.normal[0] != kNoNormal; });
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

void packMaterials(const Scene& scene, PackedScene& packed) {
  for (const Material& m : scene.materials) {
    packed.materials.push_back(texel(m.reflectance, static_cast<std::uint32_t>(m.bsdf)));
    packed.materials.push_back(texel(m.emission, m.intIor / m.extIor));
    packed.materials.push_back(texel(m.eta, 0U));
    packed.materials.push_back(texel(m.k, 0U));
  }
}

void packLights(const Scene& scene, PackedScene& packed) {
  const LightTable table = makeLightTable(scene);
  std::vector<std::uint32_t> position(scene.triangles.size());
  for (std::uint32_t i = 0; i < packed.bvh.triangleOrder.size(); ++i)
    position[packed.bvh.triangleOrder[i]] = i;
  packed.lightCount = static_cast<std::uint32_t>(table.triangles.size());
  for (std::size_t i = 0; i < table.triangles.size(); ++i) {
    const Triangle& t = scene.triangles[table.triangles[i]];
    packed.lights.push_back(texel(scene.positions[t.vertex[0]], static_cast<float>(table.rows[i].threshold)));
    packed.lights.push_back(texel(scene.positions[t.vertex[1]], table.rows[i].alias));
    packed.lights.push_back(texel(scene.positions[t.vertex[2]], static_cast<float>(table.probabilities[i])));
    packed.lights.push_back(texel(scene.materials[t.material].emission, position[table.triangles[i]]));
  }
}

} // namespace

PackedScene packScene(const Scene& scene, unsigned threads) {
  PackedScene packed;
  BvhSettings settings;
  settings.threads = threads;
  settings.maxDepth = shared::kMaxStackDepth - 1U;
  packed.bvh = buildBvh(triangleBounds(scene), settings);
  packTriangles(scene, packed);
  packMaterials(scene, packed);
  packLights(scene, packed);
  for (auto* texels : {&packed.triangles, &packed.normals, &packed.materials, &packed.lights}) {
    if (texels->empty())
      texels->push_back({});
  }
  return packed;
}

DeviceScene uploadScene(const gpu::Context& context, const PackedScene& packed) {
  DeviceScene scene;
  scene.nodes = gpu::TexelBuffer(context, "BVH nodes", std::as_bytes(std::span{packed.bvh.nodes}));
  scene.triangles = gpu::TexelBuffer(context, "triangles", std::as_bytes(std::span{packed.triangles}));
  scene.normals = gpu::TexelBuffer(context, "normals", std::as_bytes(std::span{packed.normals}));
  scene.materials = gpu::TexelBuffer(context, "materials", std::as_bytes(std::span{packed.materials}));
  scene.lights = gpu::TexelBuffer(context, "lights", std::as_bytes(std::span{packed.lights}));
  scene.lightCount = packed.lightCount;
  scene.stackDepth = packed.bvh.depth + 1U;
  return scene;
}

std::uint64_t DeviceScene::bytes() const {
  return nodes.bytes() + triangles.bytes() + normals.bytes() + materials.bytes() + lights.bytes();
}

} // namespace vkpt
