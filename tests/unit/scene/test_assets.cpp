// The scenes that are built in, and their files in assets/.

#include "unit/scene/scene_check.h"

#include <algorithm>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

Vec3d boxCentre() { return {-6.95, 6.86, -6.99}; }

TEST(CornellBox, HasTheAssignmentsMaterials) {
  const auto [scene, report] = load({"CornellBox.obj"});
  EXPECT_EQ(scene.triangles.size(), 12U);
  EXPECT_EQ(scene.materials.size(), 4U);
  EXPECT_EQ(materialNamed(scene, "white").reflectance, Vec3f(0.9F));
  EXPECT_EQ(materialNamed(scene, "red").reflectance, Vec3f(0.9F, 0, 0));
  EXPECT_EQ(materialNamed(scene, "green").reflectance, Vec3f(0, 0.9F, 0));
  EXPECT_EQ(materialNamed(scene, "light").emission, Vec3f(36.8F, 31.2F, 16.0F));
  EXPECT_EQ(materialNamed(scene, "light").reflectance, Vec3f(0.0F));
  EXPECT_EQ(materialNamed(scene, "white").emission, Vec3f(0.0F));
  EXPECT_TRUE(report.warnings.empty());
}

TEST(CornellBox, LightFacesDownJustUnderTheCeiling) {
  const auto [scene, report] = load({"CornellBox.obj"});
  const auto light = trianglesOf(scene, "light");
  ASSERT_EQ(light.size(), 2U);
  double area = 0.0;
  for (const Triangle& t : light) {
    EXPECT_LT(glm::normalize(areaVector(scene, t)).y, -0.999999);
    EXPECT_NEAR(centroid(scene, t).y, 548.7 * 0.025, 1e-5);
    area += 0.5 * glm::length(areaVector(scene, t));
  }
  EXPECT_NEAR(area, 130.0 * 105.0 * 0.025 * 0.025, 1e-4);
}

TEST(CornellBox, WallsFaceTheInsideAndAreFlat) {
  const auto [scene, report] = load({"CornellBox.obj"});
  for (const Triangle& t : scene.triangles) {
    EXPECT_GT(glm::dot(areaVector(scene, t), boxCentre() - centroid(scene, t)), 0.0);
    EXPECT_EQ(t.normal[0], kNoNormal);
  }
  EXPECT_EQ(report.inventedNormals, 0U);
}

TEST(CornellBox, RedIsLeftAndGreenRightOfTheCamera) {
  const auto [scene, report] = load({"CornellBox.obj"});
  EXPECT_LT(centroid(scene, trianglesOf(scene, "red").at(0)).x, -13.0);
  EXPECT_GT(centroid(scene, trianglesOf(scene, "green").at(0)).x, -1.0);
}

TEST(CornellBlocks, FaceOutwardsAndAreFlat) {
  const auto [scene, report] = load({"CornellBlocks.obj"});
  ASSERT_EQ(scene.triangles.size(), 20U) << "five faces each, no bottoms";
  EXPECT_EQ(report.inventedNormals, 0U);
  for (std::size_t i = 0; i < 20; ++i) {
    // The centre of the block is that of its ten triangles: the faces are parallelograms, or nearly so.
    Vec3d centre(0.0);
    for (std::size_t j = i / 10 * 10; j < i / 10 * 10 + 10; ++j) {
      centre += centroid(scene, scene.triangles[j]) / 10.0;
    }
    EXPECT_GT(glm::dot(areaVector(scene, scene.triangles[i]), centroid(scene, scene.triangles[i]) - centre),
              0.0)
        << i;
  }
}

struct Sphere {
  const char* file;
  const char* material;
  Vec3d centre; ///< in the file's units
};
const Sphere kSpheres[] = {{"CornellLeftSphere.obj", "silver", {420.2, 91.6, 369.5}},
                           {"CornellRightSphere.obj", "glass", {130.9, 91.6, 249.6}}};

Vec3d placed(const Vec3d& p) { return 0.025 * Vec3d(-p.x, p.y, -p.z); }

TEST(CornellSpheres, AreClosed) {
  for (const Sphere& sphere : kSpheres) {
    const auto [scene, report] = load({sphere.file});
    EXPECT_EQ(scene.triangles.size(), 8112U);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const Triangle& t : scene.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        ++edges[{t.vertex[i], t.vertex[(i + 1) % 3]}];
      }
    }
    // Once in each direction: shared by exactly two triangles of the same side.
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1);
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
    EXPECT_EQ(report.droppedDegenerate, 0U);
  }
}

TEST(CornellSpheres, NormalsPointOutwards) {
  for (const Sphere& sphere : kSpheres) {
    const auto [scene, report] = load({sphere.file});
    EXPECT_EQ(report.inventedNormals, scene.positions.size());
    EXPECT_TRUE(report.warnings.empty());
    const double oneDegree = std::cos(std::numbers::pi / 180.0);
    for (const Triangle& t : scene.triangles) {
      EXPECT_GT(glm::dot(areaVector(scene, t), centroid(scene, t) - placed(sphere.centre)), 0.0);
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3d radius = worldPosition(scene, t.vertex[i]) - placed(sphere.centre);
        EXPECT_NEAR(glm::length(radius), 90.0 * 0.025, 1e-5); // four digits in the file, times 0.025
        ASSERT_NE(t.normal[i], kNoNormal);
        EXPECT_GT(glm::dot(Vec3d(scene.normals[t.normal[i]]), glm::normalize(radius)), oneDegree);
      }
    }
  }
}

TEST(CornellSpheres, AreSilverAndGlass) {
  const auto [scene, report] = load({"cornell-spheres"});
  EXPECT_EQ(materialNamed(scene, "silver").bsdf, BsdfType::Conductor);
  EXPECT_EQ(materialNamed(scene, "glass").bsdf, BsdfType::Dielectric);
  EXPECT_EQ(materialNamed(scene, "glass").intIor, 1.5F);
  EXPECT_LT(centroid(scene, trianglesOf(scene, "silver").at(0)).x,
            centroid(scene, trianglesOf(scene, "glass").at(0)).x)
      << "silver is left";
  EXPECT_EQ(trianglesOf(scene, "silver").size() + trianglesOf(scene, "glass").size() + 12,
            scene.triangles.size());
  EXPECT_TRUE(report.warnings.empty());
}

} // namespace
} // namespace vkpt::test
