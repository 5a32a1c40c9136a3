// Nori's emitters, and our own beside them.

#include "unit/scene/nori_check.h"

#include <numbers>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

TEST(NoriLight, AreaLightsOfBothEditions) {
  for (const char* tag : {"luminaire", "emitter"}) {
    const std::string light =
        std::string("<") + tag + R"( type="area"><color name="radiance" value="17, 11.8, 4"/></)" + tag + ">";
    const auto [scene, report] = loadNoriBsdf(light);
    EXPECT_EQ(scene.materials.at(0).emission, Vec3f(17.0F, 11.8F, 4.0F)) << tag;
    EXPECT_TRUE(report.warnings.empty()) << tag;
  }
}

TEST(NoriLight, MeshesOfOneBsdfAndDifferentLightsAreApart) {
  const NoriFolder folder;
  const std::string light = R"(<emitter type="area"><color name="radiance" value="1 2 3"/></emitter>)";
  const Scene scene =
      folder.load(noriScene(noriMesh("plane.obj") + noriMesh("square.obj", light), true, false)).scene;
  EXPECT_EQ(materialNamed(scene, "plane").emission, Vec3f(0.0F));
  EXPECT_EQ(materialNamed(scene, "square").emission, Vec3f(1, 2, 3));
  EXPECT_EQ(trianglesOf(scene, "plane").size(), 2U);
  EXPECT_EQ(trianglesOf(scene, "square").size(), 2U);
}

TEST(NoriLight, APointLightsPowerIsSpreadOverAllDirections) {
  const NoriFolder folder;
  const Scene scene = folder
                          .load(noriScene(R"(<emitter type="point"><point name="position" value="1 2 3"/>
      <color name="power" value="1 2 4"/></emitter>
      <emitter type="point"><vector name="position" value="0 0 9"/>
      <color name="intensity" value="5 6 7"/></emitter>)"))
                          .scene;
  ASSERT_EQ(scene.pointLights.size(), 2U);
  const Vec3d first = Vec3d(scene.pointLights[0].position) + scene.origin;
  EXPECT_LT(glm::length(first - Vec3d(1, 2, 3)), 1e-6) << "relative to the origin, which is not 0";
  EXPECT_NE(scene.origin, Vec3d(0.0));
  EXPECT_FLOAT_EQ(scene.pointLights[0].intensity.z, static_cast<float>(std::numbers::inv_pi));
  EXPECT_FLOAT_EQ(scene.pointLights[0].intensity.x, static_cast<float>(0.25 * std::numbers::inv_pi));
  EXPECT_EQ(scene.pointLights[1].intensity, Vec3f(5, 6, 7));
  EXPECT_EQ(scene.pointLights[1].where.line, 4U);
}

TEST(NoriLight, DirectionalLightsAreNormalised) {
  const NoriFolder folder;
  const Scene scene =
      folder
          .load(noriScene(R"(<emitter type="directional"><vector name="direction" value="0,-3,4"/>
      <color name="irradiance" value="1 2 3"/></emitter>)"))
          .scene;
  ASSERT_EQ(scene.directionalLights.size(), 1U);
  EXPECT_EQ(scene.directionalLights[0].direction, Vec3f(0.0F, -0.6F, 0.8F));
  EXPECT_EQ(scene.directionalLights[0].irradiance, Vec3f(1, 2, 3));
}

TEST(NoriLight, AConstantIsTheBackground) {
  const NoriFolder folder;
  const Scene scene = folder
                          .load(noriScene(R"(<emitter type="constant">
      <color name="radiance" value=".5 .7 1"/></emitter>)"))
                          .scene;
  EXPECT_EQ(scene.background, Vec3f(0.5F, 0.7F, 1.0F));
}

TEST(NoriLight, AnEnvironmentIsAFileBesideTheScene) {
  const NoriFolder folder;
  folder.write("sky/Sky.HDR", "not read here");
  for (const char* type : {"environment", "envmap"}) {
    const std::string light = std::string("<emitter type='") + type +
                              "'><string name='filename' value='sky/../sky/Sky.HDR'/></emitter>";
    const Scene scene = folder.load(noriScene(light)).scene;
    EXPECT_EQ(scene.environment.file, folder.path() / "sky" / "Sky.HDR");
    EXPECT_EQ(scene.environment.width, 0);
    EXPECT_EQ(scene.environment.where.line, 2U);
  }
}

} // namespace
} // namespace vkpt::test
