#pragma once
// How the mouse moves the camera. Ways are in parts of the window's height, x to the right, y downwards.

#include "scene/scene.h"

namespace vkpt {

class CameraRig {
public:
  /// pivot: what the camera turns about, in world coordinates.
  CameraRig(const Camera& camera, const Vec3d& pivot) : m_camera(camera), m_pivot(pivot) {}

  [[nodiscard]] const Camera& camera() const { return m_camera; }
  [[nodiscard]] const Vec3d& pivot() const { return m_pivot; }
  void setPivot(const Vec3d& pivot) { m_pivot = pivot; }

  /// Turns the camera about the pivot: half a turn over the window's height. It stays upright: short of
  /// looking along `up`.
  void orbit(Vec2d way);
  /// Shifts the camera so that what lies at the pivot's depth follows the mouse.
  void pan(Vec2d way, double aspect);
  /// Goes towards the pivot by a share of the distance for each notch, and never through it.
  void dolly(double notches);
  /// Turns the view about the eye.
  void look(Vec2d way);
  /// Goes by `way` (right, up, forwards), in units of the scene; the pivot comes along.
  void fly(const Vec3d& way);
  /// Looks at the whole box from where it is seen now.
  void frame(const Box3d& box, double aspect);

private:
  struct Axes {
    Vec3d right, up, forward;
  };
  [[nodiscard]] Axes axes() const;
  [[nodiscard]] double tangent(double aspect, bool vertical) const; ///< of half the field of view
  /// Turns eye and target about a point: by `yaw` about `up`, by `pitch` about the view's right, in radians.
  void turnAbout(const Vec3d& centre, double yaw, double pitch);

  Camera m_camera;
  Vec3d m_pivot;
};

} // namespace vkpt
