#include "scene/placement.h"
#include "unit/scene/scene_check.h"

#include <cmath>

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

/// Positions are floats about the origin; the sizes here are below 16, so their rounding is below 1e-6.
constexpr double kFloatRounding = 1e-6;

TEST(Placement, CornellFilesShrinkAndTurnExactly) {
  const TempFolder folder;
  for (const char* name : {"CornellThing.obj", "cornell.obj", "CORNELLS.OBJ"}) {
    const auto [scene, report] = load({folder.write(name, "v 40 0 0\nv 80 0 0\nv 40 120 -40\nf 1 2 3\n")});
    EXPECT_EQ(worldPosition(scene, 0), Vec3d(-1, 0, 0)) << name;
    EXPECT_EQ(worldPosition(scene, 1), Vec3d(-2, 0, 0));
    EXPECT_EQ(worldPosition(scene, 2), Vec3d(-1, 3, 1));
    EXPECT_TRUE(anyContains(report.notes, "Cornell rule: x0.025, turned, camera fitted"));
  }
}

TEST(Placement, OtherFilesStayWhereTheyAre) {
  const TempFolder folder;
  const auto [scene, report] = load({folder.write("my_cornell.obj", kSquare)});
  EXPECT_EQ(worldPosition(scene, 1), Vec3d(1, 0, 0));
  ASSERT_EQ(report.notes.size(), 1U);
  EXPECT_TRUE(report.notes.front().starts_with("OBJ conventions"));
}

TEST(Placement, BunnyAndElephantGoWhereTheFrameworkPutsThem) {
  const Placement bunny = placementFor("Bunny.obj");
  EXPECT_EQ(bunny.position({1, 2, 3}), Vec3d(22, 49.15, 67)) << "scaled, then moved";
  const Placement elephant = placementFor("justelephant.obj");
  const Vec3d turned = elephant.position({1, 0, 0});
  EXPECT_LT(glm::length(turned - Vec3d(std::cos(0.5) - 10, 3, -std::sin(0.5) - 2)), 1e-15);
  EXPECT_FALSE(bunny.note.empty());
  EXPECT_FALSE(elephant.note.empty());
}

TEST(Camera, FitsTheBoxOfTheWholeScene) {
  const TempFolder folder;
  const auto [scene, report] =
      load({folder.write("a.obj", kSquare), folder.write("b.obj", "v 3 3 0\nv 3 4 0\nv 3 4 4\nf 1 2 3\n")});
  const double r = 0.5 * std::sqrt(9.0 + 16.0 + 16.0);
  EXPECT_EQ(scene.camera.target, Vec3d(1.5, 2, 2));
  EXPECT_NEAR(scene.camera.eye.z, 2 + 1.75 * r, 1e-12);
  EXPECT_EQ(scene.camera.up, Vec3d(0, 1, 0));
  EXPECT_EQ(scene.camera.fovAxis, Camera::FovAxis::Vertical);
  EXPECT_NEAR(scene.camera.fovDegrees, 53.13010235, 1e-8);
  EXPECT_EQ(scene.name, "a+b");
}

TEST(Camera, LooksAtTheCornellBoxAsTheFrameworkDoes) {
  const auto [scene, report] = load({"CornellBox.obj"});
  EXPECT_LT(glm::length(scene.camera.eye - Vec3d(-6.95, 6.86, 14.026)), 1e-3); // three digits are given
  EXPECT_LT(glm::length(scene.camera.target - Vec3d(-6.95, 6.86, -6.99)), kFloatRounding);
  EXPECT_EQ(scene.width, 512);
  EXPECT_EQ(scene.height, 512);
}

TEST(Recentring, KeepsTheShapeFarFromTheOrigin) {
  // The same triangle, of coordinates that are exact in float, at the origin and 1e5 away.
  const auto at = [](double x) {
    std::string obj;
    for (const Vec3d& p :
         {Vec3d(0.001, 0.002, 0), Vec3d(0.011, 0.003, 0.0005), Vec3d(0.004, 0.009, 0.0015)}) {
      char line[200];
      std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", x + p.x, p.y - x, p.z + x);
      obj += line;
    }
    return obj + "f 1 2 3\n";
  };
  const auto near = loadText(at(0.0));
  const auto far = loadText(at(1e5));
  EXPECT_EQ(far.scene.triangles.size(), 1U);
  for (std::size_t i = 0; i < 3; ++i) {
    // Doubles of 1e5 are 1.5e-11 apart; floats of 1e5 would be 0.008.
    EXPECT_LT(glm::length(Vec3d(near.scene.positions[i]) - Vec3d(far.scene.positions[i])), 1e-10);
  }
  EXPECT_LT(glm::length(far.scene.origin - near.scene.origin - Vec3d(1e5, -1e5, 1e5)), 1e-10);
}

TEST(Recentring, MovesByPowersOfTwoAreExact) {
  const auto near = loadText(kSquare);
  const auto far = loadText("v 131072 -65536 131072\nv 131073 -65536 131072\nv 131073 -65535 131072\n"
                            "v 131072 -65535 131072\nf 1 2 3 4\n");
  EXPECT_EQ(near.scene.positions, far.scene.positions);
}

} // namespace
} // namespace vkpt::test
