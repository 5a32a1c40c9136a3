// What shines from outside is left out where the scene is closed about the camera, and only there.
#include "device/enclosure.h"

#include "device/effects.h"
#include "device/light_table.h"
#include "scenes/made_scenes.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

const Material kWall = diffuse(Vec3f(0.5F));

/// A camera in a cube of edge 2 about the origin.
SceneBuilder cell(const Material& wall = kWall) {
  SceneBuilder builder;
  builder.box(Vec3d(-1.0), Vec3d(1.0), Facing::Inward, wall)
      .camera(lookAt({0.3, 0.1, 0.2}, {0.0, 0.0, -1.0}, 60.0));
  return builder;
}

bool isClosed(const Scene& scene) { return enclosingMaterial(scene).has_value(); }

Scene underTheSky(Scene scene) {
  scene.environment = environmentMap(4, 2, [](int, int) { return Vec3f(0.5F); });
  scene.background = Vec3f(0.1F);
  addDirectionalLight(scene, {0.0, -1.0, 0.0}, Vec3f(1.0F));
  return scene;
}

TEST(Enclosure, ACellIsClosed) {
  EXPECT_TRUE(isClosed(cell().build()));
  EXPECT_TRUE(isClosed(cell().build(1e3, {5e4, -3e4, 1e4}))) << "wherever it stands";
}

TEST(Enclosure, WithoutATriangleItIsOpen) {
  for (std::size_t i = 0; i < 12; ++i) {
    Scene scene = cell().build();
    scene.triangles.erase(scene.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(isClosed(scene)) << "without triangle " << i;
  }
}

TEST(Enclosure, ACornerMovedByTheLeastStepOpensIt) {
  Scene scene = cell().build();
  const std::uint32_t corner = scene.triangles.back().vertex[1];
  scene.positions.push_back(scene.positions[corner]);
  const auto moved = static_cast<std::uint32_t>(scene.positions.size() - 1);
  scene.triangles.back().vertex[1] = moved;
  EXPECT_TRUE(isClosed(scene)) << "another corner of the same coordinates";
  scene.positions[moved].x = std::nextafter(scene.positions[moved].x, 2.0F);
  EXPECT_FALSE(isClosed(scene));
}

TEST(Enclosure, SeenFromOutsideItIsOpen) {
  for (const Vec3d& eye : {Vec3d(0.0, 0.0, 3.0), Vec3d(-4.0, 2.0, 0.5), Vec3d(0.2, 1.01, 0.1)})
    EXPECT_FALSE(isClosed(cell().camera(lookAt(eye, Vec3d(0.0), 60.0)).build()));
}

/// Where every ray meets something, and a closed box stands in the way of the first.
TEST(Enclosure, ClosedFurnitureInAnOpenCellClosesNothing) {
  for (std::size_t i = 0; i < 12; ++i) {
    Scene scene = cell().box(Vec3d(0.5, 0.2, 0.5), Vec3d(0.6, 0.3, 0.7), Facing::Outward, kWall).build();
    scene.triangles.erase(scene.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(isClosed(scene)) << "without triangle " << i;
  }
}

TEST(Enclosure, OnTheWallItIsNotProven) {
  EXPECT_FALSE(isClosed(cell().camera(lookAt({0.3, 1.0, 0.2}, {0.0, 0.0, -1.0}, 60.0)).build()));
}

TEST(Enclosure, GlassClosesNothing) {
  EXPECT_FALSE(isClosed(cell(glass(1.5F)).build()));
  EXPECT_FALSE(isClosed(cell(roughGlass(1.5F, 0.2F)).build()));
  EXPECT_TRUE(isClosed(cell(mirror(Vec3f(0.9F))).build()));
  EXPECT_TRUE(isClosed(cell(emitter(Vec3f(1.0F))).build())) << "a lamp is opaque";
  Material backless = kWall;
  backless.twoSided = false;
  EXPECT_TRUE(isClosed(cell(backless).build())) << "a path that meets the back ends there";
}

TEST(Enclosure, FurnitureChangesNothing) {
  SceneBuilder builder = cell();
  builder.box({-0.5, -1.0, -0.5}, {0.0, 0.0, 0.0}, Facing::Outward, mirror(Vec3f(0.9F)))
      .ceiling({0.0, 0.9, 0.0}, 0.3, emitter(Vec3f(3.0F)));
  EXPECT_TRUE(isClosed(builder.build())) << "an open lamp and a closed block in a closed cell";
  builder.box({0.2, 0.0, 0.1}, {0.4, 0.2, 0.3}, Facing::Outward, glass(1.5F));
  EXPECT_TRUE(isClosed(builder.build())) << "the camera in glass, in the cell";
}

/// The parity of one part counts, not that of all that a ray meets.
TEST(Enclosure, ACellInACellIsClosedTwice) {
  SceneBuilder builder = cell();
  builder.box(Vec3d(-2.0), Vec3d(2.0), Facing::Outward, mirror(Vec3f(0.5F)));
  EXPECT_TRUE(isClosed(builder.build()));
  builder.camera(lookAt({1.5, 0.0, 0.0}, Vec3d(0.0), 60.0));
  const Scene between = builder.build();
  ASSERT_TRUE(isClosed(between));
  EXPECT_EQ(between.materials[*enclosingMaterial(between)].bsdf, BsdfType::Mirror) << "the outer one";
}

TEST(Enclosure, LeavesOutWhatShinesFromOutside) {
  const EstimatorSettings settings = misSampling();
  Scene open = cell().build();
  open.triangles.pop_back();
  const EffectSet seen = detectEffects(underTheSky(open), settings);
  const Scene scene = underTheSky(cell().build());
  const EffectReasons hidden = explainEffects(scene, settings);
  for (const Effect e :
       {Effect::Environment, Effect::Background, Effect::DeltaLights, Effect::LightSampling}) {
    EXPECT_TRUE(seen.has(e)) << effectName(e);
    EXPECT_FALSE(hidden.set.has(e)) << effectName(e);
  }
  EXPECT_NE(hidden.of(Effect::Environment).because.find("in a closed mesh"), std::string::npos);
  EXPECT_EQ(makeLightTable(underTheSky(open), settings.light).lights.size(), 2U);
  EXPECT_TRUE(makeLightTable(scene, settings.light).lights.empty())
      << "else shadow rays would be wasted on them";
  Scene lit = scene;
  addPointLight(lit, {0.0, 0.5, 0.0}, Vec3f(1.0F));
  EXPECT_TRUE(detectEffects(lit, settings).has(Effect::DeltaLights));
  EXPECT_EQ(makeLightTable(lit, settings.light).lights.size(), 1U);
}

} // namespace
} // namespace vkpt::test
