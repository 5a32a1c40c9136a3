// Whole Nori scenes: both editions of the format, the assignment's own file, and what the file says of the
// estimator.

#include "unit/scene/nori_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

constexpr std::uint32_t bit(PathKind kind) { return 1U << static_cast<std::uint32_t>(kind); }

TEST(NoriScene, TheAssignmentsFileLoadsAsItIs) {
  const fs::path file =
      fs::path(VKPT_SOURCE_DIR) / ".." / "shared" / "data" / "assignment-b" / "cbox-path.xml";
  if (!fs::is_regular_file(file)) {
    GTEST_SKIP() << "no data of the assignment: " << file;
  }
  const auto [scene, report] = load({file});
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_EQ(scene.name, "cbox-path");
  EXPECT_EQ(scene.materials.size(), 15U);
  EXPECT_EQ(scene.triangles.size(), 34U) << "17 quads";
  EXPECT_EQ(scene.width, 512);
  EXPECT_EQ(scene.height, 512);
  EXPECT_EQ(scene.defaultFrames, 256);
  EXPECT_EQ(scene.camera.eye, Vec3d(278, 273, -800));
  EXPECT_EQ(scene.camera.fovDegrees, 39.3077);
  EXPECT_FALSE(scene.camera.mirrored);
  EXPECT_EQ(scene.filter.shape, PixelFilter::Shape::Gaussian);
  EXPECT_EQ(materialNamed(scene, "cbox_4").reflectance, Vec3f(0.15F, 0.98F, 0.09F));
  EXPECT_EQ(materialNamed(scene, "cbox_7").emission, Vec3f(17.0F, 11.8F, 4.0F));
  EXPECT_EQ(materialNamed(scene, "cbox_7").reflectance, Vec3f(0.76F, 0.75F, 0.5F));
  EXPECT_FALSE(scene.defaults.light || scene.defaults.maxBounces || scene.defaults.pathKinds);
  const auto light = trianglesOf(scene, "cbox_7");
  ASSERT_EQ(light.size(), 2U);
  EXPECT_GT(areaVector(scene, light[0]).x, 0.0) << "shines out of the small box";
}

TEST(NoriScene, OfTheEditionOf2015) {
  const NoriFolder folder;
  const auto [scene, report] = folder.load(R"(<?xml version="1.0" encoding="utf-8"?>
<!-- a remark -->
<scene>
  <integrator type="path"/>
  <sampler type="independent"><integer name="sampleCount" value="8"/></sampler>
  <camera type="perspective">
    <transform name="toWorld"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
    <rfilter type="tent"/>
  </camera>
  <mesh type="obj"><string name="filename" value="square.obj"/>
    <bsdf type="phong"><color name="kd" value=".1,0,0"/><color name="ks" value=".5,.5,.5"/>
      <float name="n" value="200"/></bsdf>
    <luminaire type="area"><color name="radiance" value="1,2,3"/></luminaire>
  </mesh>
  <evaluator type="variance"><boolean name="split" value="true"/><color name="barRatio" value="1"/></evaluator>
</scene>
)");
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_EQ(scene.defaultFrames, 8);
  EXPECT_EQ(scene.filter.shape, PixelFilter::Shape::Tent);
  EXPECT_EQ(scene.materials.at(0).bsdf, BsdfType::Phong);
  EXPECT_EQ(scene.materials.at(0).emission, Vec3f(1, 2, 3));
}

TEST(NoriScene, OfTodaysEdition) {
  const NoriFolder folder;
  const auto [scene, report] = folder.load(R"(<scene>
  <integrator type="path_mis"/>
  <camera type="perspective">
    <transform name="toWorld"><scale value="-1,1,1"/>
      <lookat target="0, 0.893051, 4.41198" origin="0, 0.919769, 5.41159" up="0, 1, 0"/></transform>
    <float name="fov" value="27.7856"/>
    <integer name="height" value="600"/><integer name="width" value="800"/>
  </camera>
  <sampler type="independent"><integer name="sampleCount" value="512"/></sampler>
  <mesh type="obj"><string name="filename" value="square.obj"/><bsdf type="dielectric"/></mesh>
  <mesh type="obj"><string name="filename" value="plane.obj"/>
    <emitter type="area"><color name="radiance" value="40 40 40"/></emitter></mesh>
</scene>)");
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_EQ(scene.defaults.light, LightStrategy::Mis);
  EXPECT_EQ(materialNamed(scene, "square").bsdf, BsdfType::Dielectric);
  EXPECT_EQ(materialNamed(scene, "plane").emission, Vec3f(40.0F));
  EXPECT_FALSE(scene.camera.mirrored);
}

struct Integrator {
  const char* type;
  std::optional<LightStrategy> light;
  std::optional<std::uint32_t> maxBounces;
  std::optional<std::uint32_t> pathKinds;
};

TEST(NoriIntegrator, ChoosesTheStrategy) {
  const std::vector<Integrator> integrators{
      {"path", {}, {}, {}},
      {"path_mats", LightStrategy::Bsdf, {}, {}},
      {"path_ems", LightStrategy::Nee, {}, {}},
      {"path_mis", LightStrategy::Mis, {}, {}},
      {"direct", {}, 1U, {}},
      {"direct_mats", LightStrategy::Bsdf, 1U, {}},
      {"direct_ems", LightStrategy::Nee, 1U, {}},
      {"direct_mis", LightStrategy::Mis, 1U, {}},
      {"light", LightStrategy::Nee, 1U, {}},
      {"whitted",
       LightStrategy::Nee,
       {},
       bit(PathKind::Emission) | bit(PathKind::Direct) | bit(PathKind::Specular)},
  };
  const NoriFolder folder;
  for (const Integrator& i : integrators) {
    const auto [scene, report] = folder.load(noriScene(std::string("<integrator type='") + i.type + "'/>"));
    EXPECT_EQ(scene.defaults.light, i.light) << i.type;
    EXPECT_EQ(scene.defaults.maxBounces, i.maxBounces) << i.type;
    EXPECT_EQ(scene.defaults.pathKinds, i.pathKinds) << i.type;
    EXPECT_EQ(anyContains(report.notes, "integrator whitted: emission, direct and specular paths alone"),
              i.pathKinds.has_value())
        << i.type;
  }
}

TEST(NoriSampler, CountsFramesAndItsDefaultIsOne) {
  const NoriFolder folder;
  EXPECT_EQ(folder.load(noriScene("<sampler type='independent'/>")).scene.defaultFrames, 1);
  EXPECT_EQ(folder.load(noriScene("")).scene.defaultFrames, 64) << "the file says nothing: vkpt's own";
}

TEST(NoriFile, ExtensionsInAnyCaseAndAloneOnTheLine) {
  const NoriFolder folder;
  const fs::path xml = folder.write("A.XML", noriScene(""));
  const fs::path obj = folder.path() / "square.obj";
  EXPECT_EQ(errorOf({xml}), "");
  for (const std::string& what : {errorOf({xml, obj}), errorOf({obj, xml}), errorOf({xml, xml})}) {
    EXPECT_NE(what.find("A.XML: a Nori file is a whole scene; give it alone"), std::string::npos) << what;
  }
}

TEST(NoriFile, OfTestsIsRefusedWithTheCommandThatRunsIt) {
  const NoriFolder folder;
  const std::string test = "<test type='ttest'><scene/></test>";
  EXPECT_EQ(folder.error(test),
            "scene.xml:1:1: the file holds tests, no picture; vkpt selftest scene.xml runs them");
  EXPECT_EQ(folder.error(noriScene(test)),
            "scene.xml:2:1: the file holds tests, no picture; vkpt selftest scene.xml runs them");
}

TEST(NoriFile, ByteOrderMarksAndLineEndsOfAllKinds) {
  const NoriFolder folder;
  EXPECT_EQ(folder.error("\xEF\xBB\xBF" + noriScene("")), "");
  EXPECT_TRUE(folder.error("\xEF\xBB\xBF<scene x='1'/>").starts_with("scene.xml:1:1: "));
  EXPECT_TRUE(folder.error("<scene>\r\n\r\n  <meshh/></scene>").starts_with("scene.xml:3:3: "));
  EXPECT_TRUE(folder.error("<scene>\r\r  <meshh/></scene>").starts_with("scene.xml:3:3: "));
  EXPECT_EQ(folder.error(std::string("\xFF\xFE<\0s\0", 6)), "scene.xml: is UTF-16; save it as UTF-8");
}

} // namespace
} // namespace vkpt::test
