// How the mouse moves the camera, told by where the kernel's camera then sees points of the scene.

#include "app/view/camera_rig.h"
#include "device/camera_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace vkpt::test {
namespace {

constexpr int kWidth = 400;
constexpr int kHeight = 300;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

Vec3d vector(const shared::vec4& v) { return {v.x, v.y, v.z}; }

/// Where a point appears: in parts of the window's height from its top left corner; z: its depth.
Vec3d seen(const Camera& camera, const Vec3d& p) {
  Scene scene;
  scene.camera = camera;
  shared::FrameConstants c{};
  setView(c, scene, kWidth, kHeight);
  const Vec3d d = p - vector(c.eye);
  const Vec3d right = vector(c.right);
  const Vec3d down = vector(c.down);
  const Vec3d forward = vector(c.upperLeft) + 0.5 * (right + down);
  const double depth = glm::dot(d, forward);
  const Vec3d onPlane = d / depth - vector(c.upperLeft);
  return {glm::dot(onPlane, right) / glm::dot(right, right) * kAspect,
          glm::dot(onPlane, down) / glm::dot(down, down), depth};
}

std::vector<Camera> cameras() {
  Camera plain{{1.0, 2.0, 5.0}, {0.5, 0.0, 0.0}, {0.0, 1.0, 0.0}, 50.0, Camera::FovAxis::Horizontal, false};
  Camera mirrored = plain;
  mirrored.mirrored = true;
  Camera tilted = plain;
  tilted.up = {0.3, 0.2, 2.0};
  tilted.fovAxis = Camera::FovAxis::Vertical;
  return {plain, mirrored, tilted};
}

const Vec3d kPivot(0.2, 0.4, 0.3); // not where the cameras look

// The constants are floats.
constexpr double kFloat = 2e-5;

TEST(CameraRig, OrbitKeepsThePivotInPlaceAndFollowsTheMouse) {
  for (const Camera& camera : cameras()) {
    CameraRig rig(camera, kPivot);
    const Vec3d before = seen(camera, kPivot);
    const Vec3d nearer = kPivot + 0.3 * glm::normalize(camera.eye - kPivot);
    rig.orbit({0.05, 0.0});
    Vec3d after = seen(rig.camera(), kPivot);
    EXPECT_NEAR(glm::length(rig.camera().eye - kPivot), glm::length(camera.eye - kPivot), 1e-12);
    EXPECT_NEAR(after.z, before.z, 1e-2)
        << "yaw alone keeps the depth but for the pivot's height in the view";
    EXPECT_GT(seen(rig.camera(), nearer).x, seen(camera, nearer).x) << "what is nearer goes with the mouse";
    CameraRig pitched(camera, kPivot);
    pitched.orbit({0.0, 0.05});
    after = seen(pitched.camera(), kPivot);
    EXPECT_NEAR(after.x, before.x, kFloat);
    EXPECT_NEAR(after.y, before.y, kFloat);
    EXPECT_GT(seen(pitched.camera(), nearer).y, seen(camera, nearer).y);
  }
}

TEST(CameraRig, OrbitStaysUpright) {
  CameraRig rig(cameras()[0], kPivot);
  for (int i = 0; i < 100; ++i) {
    rig.orbit({0.01, 0.1}); // over the top, if it could
    const Vec3d view = glm::normalize(rig.camera().target - rig.camera().eye);
    ASSERT_GT(std::acos(std::abs(view.y)), 0.019);
  }
  EXPECT_LT(glm::normalize(rig.camera().target - rig.camera().eye).y, -0.99) << "it looks down from the top";
  EXPECT_GT(rig.camera().eye.y, kPivot.y);
}

TEST(CameraRig, PanMovesThePivotWithTheMouse) {
  for (const Camera& camera : cameras()) {
    CameraRig rig(camera, kPivot);
    const Vec3d before = seen(camera, kPivot);
    rig.pan({0.11, -0.07}, kAspect);
    const Vec3d after = seen(rig.camera(), kPivot); // the scene's point, not the rig's pivot
    EXPECT_NEAR(after.x - before.x, 0.11, kFloat);
    EXPECT_NEAR(after.y - before.y, -0.07, kFloat);
    EXPECT_NEAR(after.z, before.z, kFloat);
  }
}

TEST(CameraRig, DollyNearsThePivotAndNeverPassesIt) {
  CameraRig rig(cameras()[0], kPivot);
  const Vec3d before = seen(rig.camera(), kPivot);
  double distance = glm::length(rig.camera().eye - kPivot);
  for (int i = 0; i < 50; ++i) {
    rig.dolly(1.0);
    const double next = glm::length(rig.camera().eye - kPivot);
    ASSERT_LT(next, distance);
    ASSERT_GT(next, 0.0);
    distance = next;
  }
  rig.dolly(-50.0); // and back to where it was
  EXPECT_NEAR(glm::length(rig.camera().eye - cameras()[0].eye), 0.0, 1e-9);
  EXPECT_NEAR(seen(rig.camera(), kPivot).x, before.x, kFloat);
}

TEST(CameraRig, LookTurnsAboutTheEye) {
  for (const Camera& camera : cameras()) {
    CameraRig rig(camera, kPivot);
    const Vec3d before = seen(camera, kPivot);
    rig.look({0.05, 0.03});
    EXPECT_EQ(rig.camera().eye, camera.eye);
    EXPECT_LT(seen(rig.camera(), kPivot).x, before.x) << "to the right: the scene goes left";
    EXPECT_LT(seen(rig.camera(), kPivot).y, before.y);
  }
}

TEST(CameraRig, FlightGoesWhereTheViewerLooks) {
  for (const Camera& camera : cameras()) {
    CameraRig rig(camera, kPivot);
    const Vec3d before = seen(camera, kPivot);
    rig.fly({0.0, 0.0, 0.5});
    EXPECT_NEAR(seen(rig.camera(), kPivot).z, before.z - 0.5, kFloat);
    EXPECT_NEAR(glm::length(rig.pivot() - rig.camera().eye), glm::length(kPivot - camera.eye), 1e-12);
    CameraRig sideways(camera, kPivot);
    sideways.fly({0.2, 0.0, 0.0});
    EXPECT_LT(seen(sideways.camera(), kPivot).x, before.x) << "to the viewer's right";
    EXPECT_NEAR(seen(sideways.camera(), kPivot).y, before.y, kFloat);
  }
}

TEST(CameraRig, FrameSeesTheWholeBox) {
  const Box3d box{Vec3d(-3.0, 1.0, -2.0), Vec3d(4.0, 9.0, 11.0)};
  for (const Camera& camera : cameras()) {
    CameraRig rig(camera, kPivot);
    rig.frame(box, kAspect);
    double widest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3d p((corner & 1) != 0 ? box.upper.x : box.lower.x,
                    (corner & 2) != 0 ? box.upper.y : box.lower.y,
                    (corner & 4) != 0 ? box.upper.z : box.lower.z);
      const Vec3d at = seen(rig.camera(), p);
      EXPECT_GT(at.z, 0.0);
      EXPECT_GE(at.x, 0.0);
      EXPECT_LE(at.x, kAspect);
      EXPECT_GE(at.y, 0.0);
      EXPECT_LE(at.y, 1.0);
      widest = std::max(widest, std::abs(at.y - 0.5));
    }
    EXPECT_GT(widest, 0.2) << "and not from far away";
    EXPECT_EQ(rig.pivot(), box.centre());
  }
}

} // namespace
} // namespace vkpt::test
