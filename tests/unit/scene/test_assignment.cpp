// The assignment's own files, which stay out of the repository: they must load as they are.

#include "unit/scene/scene_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

class Assignment : public testing::Test {
protected:
  void SetUp() override {
    if (!fs::is_directory(m_folder)) {
      GTEST_SKIP() << "no data of the assignment in " << m_folder;
    }
  }
  [[nodiscard]] fs::path file(const char* name) const { return m_folder / name; }

private:
  fs::path m_folder = fs::path(VKPT_SOURCE_DIR) / ".." / "shared" / "data" / "assignment-a";
};

TEST_F(Assignment, BoxAndBlocksLoadWithoutWarnings) {
  const auto [scene, report] = load({file("CornellBox.obj"), file("CornellBlocks.obj")});
  EXPECT_EQ(scene.triangles.size(), 36U);
  EXPECT_EQ(scene.materials.size(), 4U);
  EXPECT_EQ(materialNamed(scene, "light").emission, Vec3f(36.8F, 31.2F, 16.0F));
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_TRUE(anyContains(report.notes, "Cornell rule: x0.025, turned, camera fitted"));
  EXPECT_FALSE(anyContains(report.notes, "built in"));
}

TEST_F(Assignment, SpheresLoadWithoutWarnings) {
  const auto [scene, report] =
      load({file("CornellBox.obj"), file("CornellLeftSphere.obj"), file("CornellRightSphere.obj")});
  EXPECT_EQ(materialNamed(scene, "silver").bsdf, BsdfType::Conductor);
  EXPECT_EQ(materialNamed(scene, "silver").eta, Vec3f(0.126136F, 0.126423F, 0.150656F));
  EXPECT_EQ(materialNamed(scene, "glass").bsdf, BsdfType::Dielectric);
  EXPECT_EQ(materialNamed(scene, "glass").intIor, 1.5F);
  EXPECT_EQ(scene.materials.size(), 6U);
  EXPECT_GT(trianglesOf(scene, "silver").size(), 7000U);
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_EQ(report.droppedDegenerate, 0U);
}

TEST_F(Assignment, SphereNormalsPointOutwards) {
  const auto [scene, report] = load({file("CornellRightSphere.obj")});
  Box3d box;
  for (std::uint32_t v = 0; v < scene.positions.size(); ++v) {
    box.extend(worldPosition(scene, v));
  }
  for (const Triangle& t : scene.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d radius = glm::normalize(worldPosition(scene, t.vertex[i]) - box.centre());
      ASSERT_NE(t.normal[i], kNoNormal);
      // Coarser towards its poles than our own mesh.
      EXPECT_GT(glm::dot(Vec3d(scene.normals[t.normal[i]]), radius), 0.999);
    }
  }
}

TEST_F(Assignment, OurBoxHasTheSameBoundsLightAndCamera) {
  const auto theirs = load({file("CornellBox.obj")});
  const auto ours = load({"CornellBox.obj"});
  EXPECT_LT(glm::length(theirs.scene.camera.eye - ours.scene.camera.eye), 1e-12);
  EXPECT_LT(glm::length(theirs.scene.origin - ours.scene.origin), 1e-12);
  EXPECT_NEAR(totalArea(theirs.scene), totalArea(ours.scene), 1e-6 * totalArea(ours.scene));
  for (const char* name : {"white", "red", "green", "light"}) {
    EXPECT_EQ(materialNamed(theirs.scene, name).reflectance, materialNamed(ours.scene, name).reflectance)
        << name;
    EXPECT_EQ(materialNamed(theirs.scene, name).emission, materialNamed(ours.scene, name).emission) << name;
    const auto a = trianglesOf(theirs.scene, name);
    const auto b = trianglesOf(ours.scene, name);
    ASSERT_EQ(a.size(), b.size()) << name;
  }
}

} // namespace
} // namespace vkpt::test
