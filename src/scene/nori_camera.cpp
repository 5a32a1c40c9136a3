#include "scene/nori_camera.h"

#include "scene/names.h"
#include "scene/nori_object.h"
#include "scene/obj_reader.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace vkpt {

namespace {

constexpr std::array<std::string_view, 1> kFilterTags{"rfilter"};
constexpr std::array<std::string_view, 1> kCameraTypes{"perspective"};
constexpr NoriRule kFov{"more than 0 and less than 180 degrees",
                        [](double x) { return x > 0.0 && x < 180.0; }};
constexpr NoriRule kRadius{"more than 0, at most 100 pixels", [](double x) { return x > 0.0 && x <= 100.0; }};

struct NoriFilter {
  std::string_view type;
  PixelFilter::Shape shape;
  double radius; ///< where the file gives none
};

constexpr std::array kFilters{
    NoriFilter{"gaussian", PixelFilter::Shape::Gaussian, 2.0},
    NoriFilter{"mitchell", PixelFilter::Shape::Mitchell, 2.0},
    NoriFilter{"tent", PixelFilter::Shape::Tent, 1.0},
    NoriFilter{"box", PixelFilter::Shape::Box, 0.5},
};

PixelFilter defaultsOf(const NoriFilter& entry) {
  PixelFilter filter;
  filter.shape = entry.shape;
  filter.radius = entry.radius;
  return filter;
}

PixelFilter readFilter(const XmlElement& element, SceneReport& report) {
  const NoriFilter& entry = noriTypeEntry(element, kFilters);
  NoriObject object(element, {}, report);
  PixelFilter filter = defaultsOf(entry);
  filter.radius = object.number("radius", kRadius, filter.radius);
  if (filter.shape == PixelFilter::Shape::Gaussian) {
    filter.stddev = object.number("stddev", kPositive, filter.stddev);
  }
  if (filter.shape == PixelFilter::Shape::Mitchell) {
    filter.b = object.number("B", kAnyNumber, filter.b);
    filter.c = object.number("C", kAnyNumber, filter.c);
  }
  object.warnOfUnread();
  return filter;
}

/// True where the columns are of one length and at right angles.
bool isSimilarity(const glm::dmat3& m) {
  constexpr double kTolerance = 1e-4; // matrices in files have a few digits; less than a pixel
  const double length = glm::length(m[2]);
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3;
    if (std::abs(glm::length(m[i]) - length) > kTolerance * length ||
        std::abs(glm::dot(m[i] / length, m[next] / length)) > kTolerance) {
      return false;
    }
  }
  return true;
}

/// Nori's camera looks along its +z, +y up, and has its +x at the right edge of the image: a right-handed
/// frame has its +x to the left of that view, so that the image is mirrored.
Camera placeCamera(const glm::dmat4& toWorld, const SourceLocation& where) {
  const glm::dmat3 frame(toWorld);
  if (!isSimilarity(frame)) {
    throw SceneError(where, "the camera's toWorld distorts the picture; "
                            "turn, move, mirror, or scale by the same factor in all directions");
  }
  Camera camera;
  camera.eye = Vec3d(toWorld[3]);
  if (!(glm::length(camera.eye) <= kLargestCoordinate)) {
    throw SceneError(where,
                     fmt::format("the camera is beyond {:g}; give smaller numbers", kLargestCoordinate));
  }
  // So far off that the sum keeps the direction's digits.
  const double distance = std::max(1.0, glm::length(camera.eye));
  camera.target = camera.eye + distance * glm::normalize(frame[2]);
  camera.up = glm::normalize(frame[1]);
  camera.mirrored = glm::determinant(frame) > 0.0;
  return camera;
}

/// Properties that vkpt reads and does not use.
void readUnused(NoriObject& object) {
  constexpr double kNearClip = 1e-4;
  constexpr double kFarClip = 1e4;
  const double nearClip = object.number("nearClip", kAnyNumber, kNearClip);
  const double farClip = object.number("farClip", kAnyNumber, kFarClip);
  if (nearClip != kNearClip || farClip != kFarClip) {
    object.report().notes.push_back(
        fmt::format("{}: nearClip {} and farClip {} are not used: nothing is cut off", object.where().text(),
                    shortNumber(nearClip), shortNumber(farClip)));
  }
  if (object.number("apertureRadius", kNotNegative, 0.0) > 0.0) {
    object.warn(object.where("apertureRadius"), "apertureRadius is not rendered: the camera is a pinhole");
  }
  static_cast<void>(object.number("focusDistance", kAnyNumber));
}

} // namespace

void readNoriCamera(const XmlElement& camera, Scene& scene, SceneReport& report) {
  static_cast<void>(noriTypeIndex(camera, kCameraTypes));
  NoriObject object(camera, kFilterTags, report);
  const auto toWorld = object.transform("toWorld");
  scene.camera = placeCamera(toWorld.value_or(glm::dmat4(1.0)), object.where("toWorld"));
  scene.camera.fovDegrees = object.number("fov", kFov, 30.0);
  scene.camera.fovAxis = Camera::FovAxis::Horizontal;
  scene.width = object.integer("width", kOneOrMore, 1280);
  scene.height = object.integer("height", kOneOrMore, 720);
  readUnused(object);
  const XmlElement* filter = object.onlyChild(kFilterTags);
  scene.filter = filter == nullptr ? defaultsOf(kFilters.front()) : readFilter(*filter, report);
  object.warnOfUnread();
}

std::string_view noriFilterName(PixelFilter::Shape shape) {
  return std::ranges::find(kFilters, shape, &NoriFilter::shape)->type;
}

} // namespace vkpt
