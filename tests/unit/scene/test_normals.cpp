#include "unit/scene/scene_check.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

const std::string kCube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                          "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(SmoothNormals, AreWeightedByTheCornersAngle) {
  // Three right angles meet in every corner of a cube, however its squares are cut: the mean is the diagonal.
  // Weighted by area or by count, the cut would show.
  const auto [scene, report] = loadText(kCube);
  ASSERT_EQ(scene.triangles.size(), 12U);
  EXPECT_EQ(report.inventedNormals, 8U);
  for (const Triangle& t : scene.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d outward = glm::normalize(worldPosition(scene, t.vertex[i]) - Vec3d(0.5));
      EXPECT_LT(glm::length(Vec3d(scene.normals.at(t.normal[i])) - outward), 1e-6); // rounding to float
    }
  }
}

TEST(SmoothNormals, AreSummedPerPositionIndexNotPerPlace) {
  // The same corner twice in the file stays an edge.
  const auto [scene, report] =
      loadText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 0 0 0\nv 0 1 0\nv 0 0 1\nf 4 5 6\n");
  EXPECT_EQ(report.inventedNormals, 0U);
}

TEST(SmoothNormals, FlatMeshesCarryNone) {
  const auto [scene, report] = loadText(kSquare);
  EXPECT_EQ(report.inventedNormals, 0U);
  EXPECT_TRUE(scene.normals.empty());
  for (const Triangle& t : scene.triangles) {
    EXPECT_EQ(t.normal[0], kNoNormal);
  }
}

TEST(SmoothNormals, BentQuadsCarrySome) {
  const auto [scene, report] = loadText("v 0 0 0\nv 1 0 0\nv 1 1 .01\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(report.inventedNormals, 4U);
}

TEST(SmoothNormals, ThatCancelAreNone) {
  const auto [scene, report] = loadText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n");
  EXPECT_EQ(scene.triangles.size(), 2U);
  EXPECT_EQ(report.inventedNormals, 0U);
  // Cut differently on its two sides: what is left of the sums is rounding.
  const auto sheet =
      loadText("v .1 .2 .3\nv 1.3 .7 .1\nv .3 1.9 .7\nv .7 1.42 .46\nf 1 2 4\nf 1 4 3\nf 1 3 2\n");
  EXPECT_EQ(sheet.scene.triangles.size(), 3U);
  EXPECT_EQ(sheet.report.inventedNormals, 0U);
}

TEST(SmoothNormals, DoNotDependOnTheUnit) {
  for (const char* scale : {"e-30", "e12"}) {
    std::string obj;
    for (const char c : kCube.substr(0, kCube.find('f'))) {
      obj.append(c == '1' ? std::string("1") + scale : std::string(1, c));
    }
    const auto [scene, report] = loadText(obj + kCube.substr(kCube.find('f')));
    EXPECT_EQ(report.inventedNormals, 8U) << scale;
    for (const Vec3f& n : scene.normals) {
      EXPECT_NEAR(glm::length(n), 1.0F, 1e-6F);
    }
  }
}

TEST(FileNormals, ZeroAndNanFallBackToTheGeometricOne) {
  for (const char* bad : {"vn 0 0 0", "vn nan 0 1", "vn 1 inf 0", "vn 0 0 1e999"}) {
    const auto [scene, report] =
        loadText(fmt::format("{}vn 0 0 1\n{}\nf 1//1 2//1 4//1\nf 2//1 3//2 4//1\n", kSquare, bad));
    ASSERT_EQ(scene.triangles.size(), 4U);
    EXPECT_NE(scene.triangles[2].normal[0], kNoNormal) << bad;
    EXPECT_EQ(scene.triangles[3].normal[0], kNoNormal) << bad;
    ASSERT_EQ(report.warnings.size(), 1U) << bad;
    EXPECT_NE(report.warnings[0].find("scene.obj:7: 1 normal is zero or not finite"), std::string::npos)
        << report.warnings[0];
  }
}

TEST(FileNormals, TurnWithTheirFile) {
  const TempFolder folder;
  const auto [scene, report] =
      load({folder.write("cornellthing.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 3\nf 1//1 2//1 3//1\n")});
  EXPECT_EQ(scene.normals.at(0), Vec3f(0, 0, -1));
}

} // namespace
} // namespace vkpt::test
