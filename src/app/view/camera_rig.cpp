#include "app/view/camera_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/gtc/quaternion.hpp>

namespace vkpt {
namespace {

constexpr double kTurnPerHeight = std::numbers::pi;
constexpr double kClosestToUp = 0.02; // radians between the view and `up` or its opposite
constexpr double kPerNotch = 0.12;    // of the distance to the pivot

} // namespace

CameraRig::Axes CameraRig::axes() const {
  const Vec3d forward = glm::normalize(m_camera.target - m_camera.eye);
  const Vec3d right = glm::normalize(glm::cross(forward, m_camera.up)) * (m_camera.mirrored ? -1.0 : 1.0);
  const Vec3d up = glm::cross(right, forward) * (m_camera.mirrored ? -1.0 : 1.0);
  return {right, up, forward};
}

double CameraRig::tangent(double aspect, bool vertical) const {
  const double own = std::tan(0.5 * m_camera.fovDegrees * std::numbers::pi / 180.0);
  const bool ownIsVertical = m_camera.fovAxis == Camera::FovAxis::Vertical;
  if (vertical == ownIsVertical)
    return own;
  return vertical ? own / aspect : own * aspect;
}

void CameraRig::turnAbout(const Vec3d& centre, double yaw, double pitch) {
  const Axes a = axes();
  const Vec3d up = glm::normalize(m_camera.up);
  const double angle = std::acos(std::clamp(glm::dot(a.forward, up), -1.0, 1.0)); // from `up` to the view
  const double after = std::clamp(angle - pitch, kClosestToUp, std::numbers::pi - kClosestToUp);
  const double handed = m_camera.mirrored ? -1.0 : 1.0;
  const glm::dquat turn = glm::angleAxis(yaw * handed, up) * glm::angleAxis(angle - after, a.right * handed);
  m_camera.eye = centre + turn * (m_camera.eye - centre);
  m_camera.target = centre + turn * (m_camera.target - centre);
}

void CameraRig::orbit(Vec2d way) { turnAbout(m_pivot, -way.x * kTurnPerHeight, -way.y * kTurnPerHeight); }

void CameraRig::look(Vec2d way) {
  // A way over the window's height turns by about the field of view.
  const double view = 2.0 * std::atan(tangent(1.0, true));
  turnAbout(m_camera.eye, -way.x * view, -way.y * view);
}

void CameraRig::pan(Vec2d way, double aspect) {
  const Axes a = axes();
  const double depth =
      std::max(glm::dot(m_pivot - m_camera.eye, a.forward), 1e-3 * glm::length(m_pivot - m_camera.eye));
  const double height = 2.0 * depth * tangent(aspect, true);
  const Vec3d shift = (a.up * way.y - a.right * way.x) * height;
  m_camera.eye += shift;
  m_camera.target += shift;
  m_pivot += shift;
}

void CameraRig::dolly(double notches) {
  const Vec3d shift = (m_pivot - m_camera.eye) * (1.0 - std::pow(1.0 - kPerNotch, notches));
  m_camera.eye += shift;
  m_camera.target += shift;
}

void CameraRig::fly(const Vec3d& way) {
  const Axes a = axes();
  const Vec3d shift = a.right * way.x + glm::normalize(m_camera.up) * way.y + a.forward * way.z;
  m_camera.eye += shift;
  m_camera.target += shift;
  m_pivot += shift;
}

void CameraRig::frame(const Box3d& box, double aspect) {
  if (box.empty())
    return;
  const Axes a = axes();
  const double radius = std::max(0.5 * glm::length(box.extent()), 1e-9);
  const double narrow = std::atan(std::min(tangent(aspect, false), tangent(aspect, true)));
  m_pivot = box.centre();
  m_camera.target = m_pivot;
  m_camera.eye = m_pivot - a.forward * (radius / std::sin(narrow));
}

} // namespace vkpt
