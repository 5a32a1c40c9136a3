// Nori's camera: its frame, its image, its filter.

#include "unit/scene/nori_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

Loaded loadCamera(const std::string& inside) {
  return NoriFolder().load(noriScene("<camera type='perspective'>" + inside + "</camera>", false));
}

Camera cameraOf(const std::string& steps) {
  return loadCamera("<transform name='toWorld'>" + steps + "</transform>").scene.camera;
}

Vec3d viewOf(const Camera& camera) { return glm::normalize(camera.target - camera.eye); }

TEST(NoriCamera, Defaults) {
  const auto [scene, report] = loadCamera("");
  EXPECT_EQ(scene.width, 1280);
  EXPECT_EQ(scene.height, 720);
  EXPECT_EQ(scene.camera.fovDegrees, 30.0);
  EXPECT_EQ(scene.camera.fovAxis, Camera::FovAxis::Horizontal);
  EXPECT_EQ(scene.camera.eye, Vec3d(0.0));
  EXPECT_EQ(viewOf(scene.camera), Vec3d(0, 0, 1));
  EXPECT_EQ(scene.camera.up, Vec3d(0, 1, 0));
  EXPECT_TRUE(scene.camera.mirrored) << "no scale -1,1,1: left and right change places";
  EXPECT_EQ(scene.filter.shape, PixelFilter::Shape::Gaussian);
  EXPECT_EQ(scene.filter.radius, 2.0);
  EXPECT_EQ(scene.filter.stddev, 0.5);
  EXPECT_TRUE(anyContains(report.notes, "Nori conventions: one-sided surfaces, normals as the file has them, "
                                        "horizontal fov, filter gaussian"));
  EXPECT_EQ(report.notes.size(), 1U);
}

TEST(NoriCamera, Values) {
  const auto [scene, report] =
      loadCamera("<float name='fov' value='39.3077'/><integer name='width' value='3'/>"
                 "<integer name='height' value='5'/>");
  EXPECT_EQ(scene.camera.fovDegrees, 39.3077);
  EXPECT_EQ(scene.width, 3);
  EXPECT_EQ(scene.height, 5);
  EXPECT_EQ(loadCamera("<float name='fov' value='1e-6'/>").scene.camera.fovDegrees, 1e-6);
}

TEST(NoriCamera, LookAtIsMirroredUnlessAScalePrecedesIt) {
  const std::string lookAt = "<lookat origin='278, 273, -800' target='278, 273, -799' up='0, 1, 0'/>";
  const Camera plain = cameraOf(lookAt);
  EXPECT_EQ(plain.eye, Vec3d(278, 273, -800));
  EXPECT_LT(glm::length(viewOf(plain) - Vec3d(0, 0, 1)), 1e-12);
  EXPECT_TRUE(plain.mirrored);
  const Camera scaled = cameraOf("<scale value='-1,1,1'/>" + lookAt);
  EXPECT_EQ(scaled.eye, plain.eye);
  EXPECT_LT(glm::length(viewOf(scaled) - Vec3d(0, 0, 1)), 1e-12);
  EXPECT_EQ(scaled.up, Vec3d(0, 1, 0));
  EXPECT_FALSE(scaled.mirrored);
}

TEST(NoriCamera, UpIsThatOfTheTurnedFrame) {
  const Camera c = cameraOf("<lookat origin='0 0 0' target='0 -1 1' up='0 1 0'/>");
  EXPECT_LT(glm::length(viewOf(c) - glm::normalize(Vec3d(0, -1, 1))), 1e-12);
  EXPECT_LT(glm::length(c.up - glm::normalize(Vec3d(0, 1, 1))), 1e-12);
  const Camera rolled = cameraOf("<rotate axis='0 0 1' angle='90'/>");
  EXPECT_LT(glm::length(rolled.up - Vec3d(-1, 0, 0)), 1e-12);
}

TEST(NoriCamera, MayBeScaledInAllDirectionsAlike) {
  const Camera c = cameraOf("<scale value='7,7,7'/><translate value='1 2 3'/>");
  EXPECT_EQ(c.eye, Vec3d(1, 2, 3));
  EXPECT_NEAR(glm::length(c.up), 1.0, 1e-12);
  EXPECT_TRUE(c.mirrored);
  const Camera inverted = cameraOf("<scale value='-2,-2,-2'/>");
  EXPECT_EQ(viewOf(inverted), Vec3d(0, 0, -1));
  EXPECT_EQ(inverted.up, Vec3d(0, -1, 0));
  EXPECT_FALSE(inverted.mirrored);
}

TEST(NoriCamera, MatricesOfAFewDigitsAreNoDistortion) {
  const Camera c = cameraOf("<matrix value='0.70711 0 0.70711 0  0 1 0 0  -0.70711 0 0.70711 0  0 0 0 1'/>");
  EXPECT_LT(glm::length(viewOf(c) - glm::normalize(Vec3d(1, 0, 1))), 1e-5);
}

TEST(NoriCamera, FarOffKeepsItsDirection) {
  const Camera c = cameraOf("<lookat origin='1e9 0 0' target='0 1e9 0' up='0 0 1'/>");
  EXPECT_LT(glm::length(viewOf(c) - glm::normalize(Vec3d(-1, 1, 0))), 1e-12);
}

TEST(NoriCamera, FiltersWithTheirParameters) {
  const auto filter = [](const std::string& element) { return loadCamera(element).scene.filter; };
  const PixelFilter box = filter("<rfilter type='box'/>");
  EXPECT_EQ(box.shape, PixelFilter::Shape::Box);
  EXPECT_EQ(box.radius, 0.5);
  const PixelFilter tent = filter("<rfilter type='tent'/>");
  EXPECT_EQ(tent.shape, PixelFilter::Shape::Tent);
  EXPECT_EQ(tent.radius, 1.0);
  const PixelFilter gaussian = filter("<rfilter type='gaussian'><float name='radius' value='3'/>"
                                      "<float name='stddev' value='.7'/></rfilter>");
  EXPECT_EQ(gaussian.shape, PixelFilter::Shape::Gaussian);
  EXPECT_EQ(gaussian.radius, 3.0);
  EXPECT_EQ(gaussian.stddev, 0.7);
  const PixelFilter mitchell = filter("<rfilter type='mitchell'/>");
  EXPECT_EQ(mitchell.shape, PixelFilter::Shape::Mitchell);
  EXPECT_EQ(mitchell.radius, 2.0);
  EXPECT_EQ(mitchell.b, 1.0 / 3.0);
  EXPECT_EQ(mitchell.c, 1.0 / 3.0);
  const PixelFilter other =
      filter("<rfilter type='mitchell'><float name='B' value='1'/><float name='C' value='0'/></rfilter>");
  EXPECT_EQ(other.b, 1.0);
  EXPECT_EQ(other.c, 0.0);
  EXPECT_TRUE(anyContains(loadCamera("<rfilter type='box'/>").report.notes, "filter box"));
}

TEST(NoriCamera, ClipsAreNotedAndTheLensIsWarnedAbout) {
  EXPECT_FALSE(anyContains(loadCamera("<float name='nearClip' value='1e-4'/>").report.notes, "nearClip"));
  EXPECT_TRUE(anyContains(loadCamera("<float name='nearClip' value='10'/>").report.notes,
                          "scene.xml:2:1: nearClip 10 and farClip 10000 are not used"));
  const auto lens =
      loadCamera("<float name='apertureRadius' value='.5'/><float name='focusDistance' value='2'/>");
  ASSERT_EQ(lens.report.warnings.size(), 1U);
  EXPECT_TRUE(anyContains(lens.report.warnings,
                          "scene.xml:2:28: apertureRadius is not rendered: the camera is a pinhole"));
  EXPECT_TRUE(loadCamera("<float name='apertureRadius' value='0'/>").report.warnings.empty());
}

} // namespace
} // namespace vkpt::test
