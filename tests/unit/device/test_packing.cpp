// What no effect reads is not packed.
#include "device/packed_scene.h"
#include "scene/load.h"
#include "scenes/made_scenes.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace vkpt::test {
namespace {

using namespace shared;

/// Texels of everything but the BVH.
std::size_t texels(const PackedScene& p) {
  return p.triangles.size() + p.normals.size() + p.materials.size() + p.lights.size() + p.lightNodes.size() +
         p.uvs.size() + p.textures.size() + p.environment.size();
}

Scene textured() {
  Scene scene = SceneBuilder()
                    .floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F)))
                    .quad({-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1}, mirror(Vec3f(0.5F)))
                    .ceiling({0, 2, 0}, 0.5, emitter(Vec3f(1.0F)))
                    .build();
  textureLastQuad(scene, textureOf(2, 2, std::vector<Vec3f>(4, Vec3f(0.5F))), {});
  return scene;
}

TEST(Packing, AFlatDiffuseSceneHasNoNormalsNoUvsNoTextures) {
  const fs::path name("cornell");
  SceneReport report;
  const Scene scene = loadScene({&name, 1}, report);
  const PackedScene packed = packScene(scene, misSampling(), 1);
  EXPECT_EQ(packed.triangles.size(), scene.triangles.size() * kTexelsPerTriangle);
  EXPECT_EQ(packed.normals.size(), kTexelsPerTriangle) << "a dummy";
  EXPECT_EQ(packed.uvs.size(), kTexelsPerUv);
  EXPECT_EQ(packed.textures.size(), 1U);
  EXPECT_EQ(packed.environment.size(), kTexelsPerEnvironmentTexel);
  EXPECT_EQ(packed.lights.size(), packed.lightChoice.count * kTexelsPerLight);
}

TEST(Packing, LightsAreNotPackedWhereNoneIsSampled) {
  const Scene scene = textured();
  EXPECT_EQ(packScene(scene, misSampling(), 1).lights.size(), 2 * kTexelsPerLight);
  EXPECT_EQ(packScene(scene, bsdfSampling(), 1).lights.size(), kTexelsPerLight) << "a dummy";
  EXPECT_EQ(packScene(scene, withBounces(misSampling(), 0), 1).lights.size(), kTexelsPerLight);
}

TEST(Packing, ATextureThatNobodyReadsHasNoPixels) {
  Scene scene = textured(); // on the lamp, which reflects nothing
  EXPECT_EQ(packScene(scene, {}, 1).textures.size(), 1U) << "a dummy";
  EXPECT_EQ(packScene(scene, {}, 1).uvs.size(), kTexelsPerUv);
  scene.materials[scene.triangles.front().material].texture = 1;
  scene.textures.push_back(textureOf(2, 1, {Vec3f(0.2F), Vec3f(0.9F)}));
  const PackedScene packed = packScene(scene, {}, 1);
  EXPECT_EQ(packed.textures.size(), 2U + 1U) << "two headers, and two pixels of one texture";
  EXPECT_EQ(packed.uvs.size(), scene.triangles.size() * kTexelsPerUv);
  EXPECT_EQ(packed.materials[scene.triangles.back().material * kTexelsPerMaterial + 4][3], kNoTexture)
      << "else pixels that are not there would be read";
}

TEST(Packing, ATextureOfOneColourIsNotPacked) {
  Scene scene = textured();
  scene.materials[scene.triangles.front().material].texture = 0;
  const float albedo = scene.materials[scene.triangles.front().material].reflectance.x;
  for (const EffectSet& effects : {detectEffects(scene, {}), EffectSet::all()}) {
    const PackedScene packed = packScene(scene, {}, effects, 1);
    const Texel* material = &packed.materials[scene.triangles.front().material * kTexelsPerMaterial];
    EXPECT_EQ(material[4][3], kNoTexture);
    EXPECT_EQ(std::bit_cast<float>(material[0][0]), 0.5F * albedo) << "its four pixels are 0.5";
  }
  EXPECT_EQ(packScene(scene, {}, 1).uvs.size(), kTexelsPerUv) << "a dummy";
}

TEST(Packing, AllEffectsHaveWhatTheyRead) {
  const Scene scene = variety();
  const PackedScene all = packScene(scene, misSampling(), EffectSet::all(), 1);
  EXPECT_EQ(all.normals.size(), scene.triangles.size() * kTexelsPerTriangle);
  EXPECT_EQ(all.uvs.size(), scene.triangles.size() * kTexelsPerUv);
  const Scene plain = SceneBuilder().floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F))).build();
  const PackedScene empty = packScene(plain, misSampling(), EffectSet::all(), 1);
  EXPECT_EQ(empty.lights.size(), kTexelsPerLight) << "read, though never used";
  EXPECT_EQ(empty.environment.size(), kTexelsPerEnvironmentTexel);
  EXPECT_LT(texels(packScene(plain, misSampling(), 1)), texels(empty));
}

TEST(Packing, TrianglesThatAreNothingAreLeftOut) {
  Scene scene = SceneBuilder()
                    .floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F)))
                    .box({-0.5, 0.1, -0.5}, {0.5, 0.9, 0.5}, Facing::Outward, glass(1.0F))
                    .ceiling({0, 2, 0}, 0.5, emitter(Vec3f(1.0F)))
                    .build();
  const PackedScene packed = packScene(scene, misSampling(), 1);
  EXPECT_EQ(packed.leftOut, 12U);
  EXPECT_EQ(packed.triangles.size(), 4 * kTexelsPerTriangle);
  std::set<std::uint32_t> ids;
  for (std::size_t i = 0; i < packed.triangles.size(); i += kTexelsPerTriangle) {
    const std::uint32_t id = packed.triangles[i + 1][3];
    ids.insert(id);
    EXPECT_EQ(packed.triangles[i][3], scene.triangles.at(id).material);
  }
  EXPECT_EQ(ids, (std::set<std::uint32_t>{0, 1, 14, 15})) << "input numbers";
  const PackedScene all = packScene(scene, misSampling(), EffectSet::all(), 1);
  EXPECT_EQ(all.leftOut, 12U) << "else --effects all would give other paths";
  for (std::size_t light = 0; light < 2; ++light) {
    const std::uint32_t at = packed.lights[light * kTexelsPerLight + 3][3]; // the triangle in BVH order
    EXPECT_EQ(packed.triangles[at * kTexelsPerTriangle + 1][3], 14 + light);
  }
}

} // namespace
} // namespace vkpt::test
