#include "unit/scene/scene_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

/// The corners' world positions, triangle by triangle.
std::vector<Vec3d> soup(const Scene& scene) {
  std::vector<Vec3d> points;
  for (const Triangle& t : scene.triangles) {
    for (const std::uint32_t v : t.vertex) {
      points.push_back(worldPosition(scene, v));
    }
  }
  return points;
}

TEST(Obj, NegativeIndicesCountBackwardsFromTheFace) {
  const auto forward = loadText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 4 5 6\n");
  const auto backward =
      loadText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf -3 5 -1\n");
  EXPECT_EQ(soup(forward.scene), soup(backward.scene));
  EXPECT_EQ(backward.scene.triangles.size(), 2U);
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(soup(loadText("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").scene),
            soup(loadText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").scene));
}

TEST(Obj, LineEndsAndAMissingLastOneChangeNothing) {
  const std::string unix = "mtllib scene.mtl\n# box\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl red\ng a b\nf 1 2 3";
  const std::string mtl = "newmtl red\nKd 1 0 0\nillum 1";
  std::string dos;
  std::string dosMtl;
  for (const char c : unix) {
    dos.append(c == '\n' ? "\r\n" : std::string(1, c));
  }
  for (const char c : mtl) {
    dosMtl.append(c == '\n' ? "\r\n" : std::string(1, c));
  }
  for (const auto& [obj, materials] : {std::pair(unix, mtl), {unix + "\n", mtl + "\n"}, {dos, dosMtl}}) {
    const auto [scene, report] = loadText(obj, materials);
    EXPECT_EQ(scene.triangles.size(), 1U);
    EXPECT_EQ(materialNamed(scene, "red").reflectance, Vec3f(1, 0, 0));
    EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  }
}

TEST(Obj, CornerFormsMayBeMixed) {
  const auto [scene, report] = loadText(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 2\nvn 0 1 1\n"
      "f 1//1 2//1 3//2\nf 1/1/1 2/1/-1 4/1/2\nf 1/1 3/1 4/1\nf 2 3 4\nf 3//1 2 1/1/1\nf 4/ 2/ 1/\n");
  ASSERT_EQ(scene.triangles.size(), 6U);
  const auto normal = [&](std::size_t t, std::size_t corner) {
    return scene.normals.at(scene.triangles[t].normal[corner]);
  };
  EXPECT_EQ(normal(0, 0), Vec3f(0, 0, 1)) << "made unit length";
  EXPECT_NEAR(normal(0, 2).y, std::sqrt(0.5), 1e-7);
  EXPECT_NEAR(normal(1, 1).y, std::sqrt(0.5), 1e-7) << "negative index of a normal";
  for (std::size_t t = 2; t < 6; ++t) {
    EXPECT_EQ(scene.triangles[t].normal[0], kNoNormal) << "all three or none: " << t;
    EXPECT_EQ(scene.triangles[t].normal[2], kNoNormal);
  }
  EXPECT_EQ(report.inventedNormals, 0U) << "a file with vn gets no others";
}

TEST(Obj, SeveralMaterialsInOneMeshAndGroupsBetween) {
  const auto [scene, report] =
      loadText(std::string("mtllib scene.mtl\no thing\ng one\nusemtl a\n") + std::string(kSquare) +
                   "g two\ns 1\nusemtl b\nf 4 3 2\ng\nusemtl a\nf 1 2 4\n",
               "newmtl a\nKd .1 .1 .1\nnewmtl b\nKd .2 .2 .2\nnewmtl unused\nillum 99\n");
  EXPECT_EQ(trianglesOf(scene, "a").size(), 3U);
  EXPECT_EQ(trianglesOf(scene, "b").size(), 1U);
  EXPECT_EQ(scene.materials.size(), 2U) << "unused materials stay out, and do not warn";
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Obj, PolygonsKeepTheirArea) {
  EXPECT_NEAR(totalArea(loadText("v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nf 1 2 3 4\n").scene), 8.0, 1e-6);
  EXPECT_NEAR(
      totalArea(loadText("v 2 0 0\nv 1 2 0\nv -1 2 0\nv -2 0 0\nv -1 -2 0\nv 1 -2 0\nf 1 2 3 4 5 6\n").scene),
      12.0, 1e-6);
  const auto arrow = loadText("v 100 0 0\nv 102 0 0\nv 100.5 .5 0\nv 100 2 0\nf 1 2 3 4\n");
  EXPECT_NEAR(totalArea(arrow.scene), 1.0, 1e-6) << "concave";
  for (const Triangle& t : arrow.scene.triangles) {
    EXPECT_GT(areaVector(arrow.scene, t).z, 0.0);
  }
}

TEST(Obj, TrianglesWithoutAreaAreDroppedAndCounted) {
  const auto [scene, report] =
      loadText(std::string(kSquare) + "f 1 1 2\nv 2 0 0\nv 3 0 0\nf 2 5 6\nf 3 3 3\n");
  EXPECT_EQ(scene.triangles.size(), 2U);
  EXPECT_EQ(report.droppedDegenerate, 3U);
  EXPECT_EQ(countContaining(report.warnings, "scene.obj:6: 3 triangles of zero area dropped"), 1U);
}

TEST(Obj, AreaIsJudgedByTheFloatsThatAreRendered) {
  // A triangle of height 1e-9 at x = 1: an area in double, none in the floats about the centre of the scene.
  const auto [scene, report] = loadText("v -1 0 0\nv 1 0 0\nv 0 5 0\nf 1 2 3\n"
                                        "v .9 1 0\nv .9 2 0\nv .900000001 1.5 0\nf 4 5 6\n"
                                        "v 0 1.1 0\nv 0 2.2 0\nv .0000001 1.7 0\nf 7 8 9\n");
  EXPECT_EQ(scene.triangles.size(), 2U) << "the third is thin, but has an area";
  EXPECT_EQ(report.droppedDegenerate, 1U);
}

TEST(Obj, ExactDuplicatesAreDroppedAndCounted) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 -0.0 0\nv 1 1 0\n";
  // Turned, and once over other vertices at the same places; the last shares two corners only.
  const auto [scene, report] = loadText(corners + "f 1 2 3\nf 2 3 1\nf 3 1 4\nf 1 2 3\nf 1 2 5\n");
  EXPECT_EQ(scene.triangles.size(), 2U);
  EXPECT_EQ(report.droppedDuplicates, 3U);
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_TRUE(report.warnings[0].ends_with(
      "scene.obj:7: 3 triangles dropped for being exactly on an earlier one, the first here"))
      << report.warnings[0];
}

TEST(Obj, OfTwinsOfDifferentMaterialTheFirstIsKept) {
  const std::string corners = "mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string mtl = "newmtl a\nillum 1\nKd .5 .5 .5\nnewmtl b\nillum 1\nKd .25 .5 .5\n";
  const auto same = loadText(corners + "usemtl b\nf 1 2 3\nusemtl a\nf 2 3 1\n", mtl);
  ASSERT_EQ(same.scene.triangles.size(), 1U);
  EXPECT_EQ(same.scene.materials[same.scene.triangles[0].material].name, "b");
  EXPECT_EQ(same.report.droppedDuplicates, 1U);
  EXPECT_EQ(countContaining(
                same.report.warnings,
                "scene.obj:8: 1 triangle of another material dropped for being exactly on an earlier one"),
            1U);
  // The other side of it may be another material's, though it is never seen; of the same material it is no
  // twin.
  const auto back = loadText(corners + "usemtl b\nf 1 2 3\nusemtl a\nf 3 2 1\n", mtl);
  EXPECT_EQ(back.scene.triangles.size(), 2U);
  EXPECT_EQ(countContaining(back.report.warnings,
                            "scene.obj:8: 1 triangle back to back with an earlier one of "
                            "another material, which is what is seen"),
            1U);
  const auto leaf = loadText(corners + "usemtl b\nf 1 2 3\nf 3 2 1\n", mtl);
  EXPECT_EQ(leaf.scene.triangles.size(), 2U);
  EXPECT_TRUE(leaf.report.warnings.empty());
}

TEST(Obj, UnreferencedVerticesDoNotMoveTheCamera) {
  const auto plain = loadText(kSquare);
  const auto stray = loadText(std::string(kSquare) + "v 1000 1000 1000\n");
  EXPECT_EQ(plain.scene.camera.eye, stray.scene.camera.eye);
  EXPECT_EQ(stray.scene.positions.size(), 4U);
}

TEST(Obj, UnknownRecordsAreOneWarning) {
  const auto [scene, report] = loadText(std::string(kSquare) + "cstype bezier\ndeg 3\nl 1 2\np 1\n");
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_NE(report.warnings[0].find("scene.obj:6: 'cstype'"), std::string::npos) << report.warnings[0];
}

TEST(Obj, ColoursAndWeightsBehindAVertexAreLeftAlone) {
  EXPECT_EQ(loadText("v 0 0 0 1\nv 1 0 0 1 0 0\nv 0 1 0 0.5 0.5 0.5 1\nf 1 2 3\n").scene.triangles.size(),
            1U);
}

} // namespace
} // namespace vkpt::test
