// Nori's meshes: transforms, normals, and which side is the front.

#include "unit/scene/nori_check.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

Loaded loadMesh(std::string_view file, const std::string& steps) {
  const std::string transform = "<transform name='toWorld'>" + steps + "</transform>";
  return NoriFolder().load(noriScene(noriMesh(file, transform), true, false));
}

Box3d boxOf(const Scene& scene) {
  Box3d box;
  for (std::uint32_t v = 0; v < scene.positions.size(); ++v) {
    box.extend(worldPosition(scene, v));
  }
  return box;
}

void expectBox(const Scene& scene, const Vec3d& lower, const Vec3d& upper) {
  const Box3d box = boxOf(scene);
  EXPECT_LT(glm::length(box.lower - lower), 1e-5);
  EXPECT_LT(glm::length(box.upper - upper), 1e-5);
}

Vec3d frontOf(const Scene& scene) { return glm::normalize(areaVector(scene, scene.triangles.at(0))); }

TEST(NoriTransform, StepsApplyInTheOrderOfTheDocument) {
  expectBox(loadMesh("square.obj", "<scale value='2,3,4'/><translate value='10,0,0'/>").scene, {10, 0, 0},
            {12, 3, 0});
  expectBox(loadMesh("square.obj", "<translate value='10,0,0'/><scale value='2,3,4'/>").scene, {20, 0, 0},
            {22, 3, 0});
}

TEST(NoriTransform, RotationsAreInDegreesAboutAnAxisOfAnyLength) {
  expectBox(loadMesh("square.obj", "<rotate axis='0 0 5' angle='90'/>").scene, {-1, 0, 0}, {0, 1, 0});
  expectBox(loadMesh("square.obj", "<rotate angle='-90' axis='0,1,0'/>").scene, {0, 0, 0}, {0, 1, 1});
}

TEST(NoriTransform, MatricesAreGivenRowByRow) {
  const std::string steps = "<matrix value='1 0 0 5  0 2 0 6  0 0 1 7  0 0 0 1'/>";
  expectBox(loadMesh("square.obj", steps).scene, {5, 6, 7}, {6, 8, 7});
  expectBox(loadMesh("square.obj", "<translate value='1,0,0'/>" + steps).scene, {6, 6, 7}, {7, 8, 7});
  const std::string value = "<transform name='toWorld' value='1 0 0 5; 0 2 0 6; 0,0,1,7; 0 0 0 1'/>";
  expectBox(NoriFolder().load(noriScene(noriMesh("square.obj", value), true, false)).scene, {5, 6, 7},
            {6, 8, 7});
}

TEST(NoriTransform, LookAtPutsTheMeshesZAxisAlongTheView) {
  // left = up x direction = y x x = -z
  expectBox(loadMesh("square.obj", "<lookat origin='0,0,0' target='3,0,0' up='0,1,0'/>").scene, {0, 0, -1},
            {0, 1, 0});
}

TEST(NoriTransform, PositionsFarOffAreRecentredInDouble) {
  const Scene scene = loadMesh("square.obj", "<translate value='1e8,0,0'/>").scene;
  EXPECT_NEAR(totalArea(scene), 1.0, 1e-6);
  EXPECT_EQ(scene.origin, Vec3d(1e8 + 0.5, 0.5, 0.0));
}

TEST(NoriMesh, NoSmoothNormalsAreInvented) {
  const NoriFolder folder;
  folder.write("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 .3\nv 0 1 0\nf 1 2 3 4\n");
  const auto [scene, report] = folder.load(noriScene(noriMesh("bent.obj"), true, false));
  EXPECT_EQ(scene.triangles.at(0).normal[0], kNoNormal);
  EXPECT_TRUE(scene.normals.empty());
  EXPECT_EQ(report.inventedNormals, 0U);
}

TEST(NoriMesh, NormalsGoByTheInverseTransposeAndAreNormalised) {
  const NoriFolder folder;
  folder.write("slope.obj", "v 0 0 0\nv 1 0 0\nv 0 1 -1\nvn 0 .70710678 .70710678\nf 1//1 2//1 3//1\n");
  const std::string transform = "<transform name='toWorld'><scale value='1,1,2'/></transform>";
  const Scene scene = folder.load(noriScene(noriMesh("slope.obj", transform), true, false)).scene;
  ASSERT_EQ(scene.normals.size(), 1U);
  EXPECT_LT(glm::length(Vec3d(scene.normals[0]) - glm::normalize(Vec3d(0, 1, 0.5))), 1e-6);
  EXPECT_LT(glm::length(frontOf(scene) - glm::normalize(Vec3d(0, 1, 0.5))), 1e-6);
}

TEST(NoriMesh, TheFrontIsOnTheSideOfTheNormals) {
  EXPECT_EQ(frontOf(loadMesh("plane.obj", "").scene), Vec3d(0, 1, 0));
  // The light of the course's scene: scaled by -1 in y it shines downwards.
  const Scene light = loadMesh("plane.obj", "<scale value='20,-1,20'/><translate value='0,80,50'/>").scene;
  for (const Triangle& t : light.triangles) {
    EXPECT_EQ(glm::normalize(areaVector(light, t)), Vec3d(0, -1, 0));
    for (const std::uint32_t normal : t.normal) {
      EXPECT_EQ(light.normals.at(normal), Vec3f(0, -1, 0));
    }
  }
  const Scene turned = loadMesh("plane.obj", "<rotate axis='1,0,0' angle='180'/>").scene;
  EXPECT_LT(glm::length(frontOf(turned) - Vec3d(0, -1, 0)), 1e-12);
}

TEST(NoriMesh, CornersThatChangePlacesKeepTheirNormals) {
  const NoriFolder folder;
  folder.write("back.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nvn .6 0 -.8\nvn 0 .6 -.8\nf 1//1 2//2 3//3\n");
  const Scene scene = folder.load(noriScene(noriMesh("back.obj"), true, false)).scene;
  EXPECT_EQ(frontOf(scene), Vec3d(0, 0, -1));
  const Triangle& t = scene.triangles.at(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d p = worldPosition(scene, t.vertex[i]);
    const Vec3f n = scene.normals.at(t.normal[i]);
    EXPECT_NEAR(p.x, n.x / 0.6, 1e-6);
    EXPECT_NEAR(p.y, n.y / 0.6, 1e-6);
  }
}

TEST(NoriMesh, ATriangleThatMissesANormalHasNone) {
  const NoriFolder folder;
  folder.write("some.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 -1\nvn 0 0 0\n"
                           "f 1//1 2//1 3\nf 1//1 2//2 4//1\nf 1//1 2//1 3//1\n");
  const Scene scene = folder.load(noriScene(noriMesh("some.obj"), true, false)).scene;
  ASSERT_EQ(scene.triangles.size(), 3U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(scene.triangles[i].normal, (std::array{kNoNormal, kNoNormal, kNoNormal}));
    EXPECT_EQ(glm::normalize(areaVector(scene, scene.triangles[i])), Vec3d(0, 0, 1)) << "its winding decides";
  }
  EXPECT_EQ(glm::normalize(areaVector(scene, scene.triangles[2])), Vec3d(0, 0, -1));
}

TEST(NoriMesh, WithoutNormalsTheWindingOfTheMovedCornersDecides) {
  EXPECT_EQ(frontOf(loadMesh("square.obj", "").scene), Vec3d(0, 0, 1));
  EXPECT_EQ(frontOf(loadMesh("square.obj", "<scale value='-1,1,1'/>").scene), Vec3d(0, 0, -1))
      << "a mirror turns it round";
}

TEST(NoriMesh, MaterialsAndGroupsOfTheObjAreReadOver) {
  const NoriFolder folder;
  folder.write("groups.obj", "mtllib gone.mtl\no a\ng b\nusemtl c\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 8 0\n"
                             "s off\nf 1/1 2/1 3/1\n");
  const auto [scene, report] = folder.load(noriScene(noriMesh("groups.obj"), true, false));
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials.at(0).reflectance, Vec3f(0.5F));
  EXPECT_EQ(scene.triangles.at(0).uv[0], kNoUv);
}

TEST(NoriMesh, AFileNamedTwiceIsReadOnce) {
  const NoriFolder folder;
  folder.write("odd.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nstrange\n");
  const std::string moved = "<transform name='toWorld'><translate value='0,0,5'/></transform>";
  const auto [scene, report] =
      folder.load(noriScene(noriMesh("odd.obj") + noriMesh("./odd.obj", moved), true, false));
  EXPECT_EQ(countContaining(report.warnings, "odd.obj:5"), 1U);
  EXPECT_EQ(scene.triangles.size(), 2U);
  EXPECT_EQ(scene.triangles.at(0).material, 0U);
  EXPECT_EQ(scene.triangles.at(1).material, 1U);
  expectBox(scene, {0, 0, 0}, {1, 1, 5});
}

TEST(NoriMesh, OnlyVerticesInUseAreKept) {
  const NoriFolder folder;
  folder.write("far.obj", "v 9e9 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 1 0 0\nf 2//1 3//1 4//1\n");
  const Scene scene = folder.load(noriScene(noriMesh("far.obj"), true, false)).scene;
  EXPECT_EQ(scene.positions.size(), 3U);
  EXPECT_EQ(scene.normals.size(), 1U);
  expectBox(scene, {0, 0, 0}, {1, 1, 0});
}

TEST(NoriMesh, TrianglesWithoutAreaAreDroppedAndCounted) {
  const NoriFolder folder;
  folder.write("thin.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 2\nf 3 3 1\n");
  const auto [scene, report] =
      folder.load(noriScene(noriMesh("square.obj") + noriMesh("thin.obj"), true, false));
  EXPECT_EQ(scene.triangles.size(), 3U);
  EXPECT_EQ(report.droppedDegenerate, 2U);
  EXPECT_TRUE(anyContains(report.warnings, "thin.obj:5: 2 triangles of zero area dropped, the first here"));
  EXPECT_EQ(trianglesOf(scene, "thin").size(), 1U);
}

TEST(NoriMesh, ConcaveFacesKeepTheirArea) {
  const NoriFolder folder;
  folder.write("notch.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 .5 0\nv 0 2 0\nf 1 2 3 4 5\n");
  EXPECT_NEAR(totalArea(folder.load(noriScene(noriMesh("notch.obj"), true, false)).scene), 2.5, 1e-6);
}

} // namespace
} // namespace vkpt::test
