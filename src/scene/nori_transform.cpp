#include "scene/nori_transform.h"

#include "scene/names.h"
#include "scene/nori_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace vkpt {

namespace {

Vec3d tripleOf(const XmlElement& step, std::string_view attribute) {
  return noriTriple(step.require(attribute), step.where, fmt::format("{} {}", step.tag, attribute), "x y z");
}

glm::dmat4 translation(const XmlElement& step) {
  return glm::translate(glm::dmat4(1.0), tripleOf(step, "value"));
}

glm::dmat4 scaling(const XmlElement& step) { return glm::scale(glm::dmat4(1.0), tripleOf(step, "value")); }

glm::dmat4 rotation(const XmlElement& step) {
  const Vec3d axis = tripleOf(step, "axis");
  const double degrees = noriNumber(step.require("angle"), step.where, "rotate angle");
  if (axis == Vec3d(0.0)) {
    throw SceneError(step.where, "rotate about an axis of length 0; give a direction, such as 0,1,0");
  }
  return glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::normalize(axis));
}

/// Columns: left, up, direction, origin; a camera looks along its +z.
glm::dmat4 lookAt(const XmlElement& step) {
  const Vec3d origin = tripleOf(step, "origin");
  const Vec3d target = tripleOf(step, "target");
  const Vec3d up = tripleOf(step, "up");
  if (origin == target) {
    throw SceneError(step.where, "lookat from a point to itself; move the origin or the target");
  }
  const Vec3d direction = glm::normalize(target - origin);
  const Vec3d across = glm::cross(glm::normalize(up), direction);
  constexpr double kLeastSine = 1e-6;
  if (!(glm::length(across) > kLeastSine)) {
    throw SceneError(step.where, "lookat: up is 0 or parallel to the view; give another one, such as 0,1,0");
  }
  const Vec3d left = glm::normalize(across);
  return {{left, 0.0}, {glm::cross(direction, left), 0.0}, {direction, 0.0}, {origin, 1.0}};
}

/// 16 numbers, row by row; `value` of <transform> has a ; behind a row.
glm::dmat4 matrixOf(std::string text, const SourceLocation& where) {
  std::ranges::replace(text, ';', ' ');
  const std::vector<double> numbers = noriNumbers(text, where, "matrix");
  if (numbers.size() != 16) {
    throw SceneError(where,
                     fmt::format("a matrix of {} numbers; give 16, four rows of four", numbers.size()));
  }
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix[column][row] = numbers[static_cast<std::size_t>(4 * row + column)];
    }
  }
  if (glm::row(matrix, 3) != glm::dvec4(0.0, 0.0, 0.0, 1.0)) {
    throw SceneError(where, "the matrix is a projection; its last row must be 0 0 0 1");
  }
  return matrix;
}

glm::dmat4 matrixStep(const XmlElement& step) { return matrixOf(step.require("value"), step.where); }

struct Step {
  std::string_view tag;
  glm::dmat4 (*read)(const XmlElement&);
  std::array<std::string_view, 3> attributes;
};

constexpr std::array kSteps{
    Step{"translate", translation, {"value"}},   Step{"scale", scaling, {"value"}},
    Step{"rotate", rotation, {"axis", "angle"}}, Step{"lookat", lookAt, {"origin", "target", "up"}},
    Step{"matrix", matrixStep, {"value"}},
};

glm::dmat4 readStep(const XmlElement& step) {
  const auto found = std::ranges::find(kSteps, step.tag, &Step::tag);
  if (found == kSteps.end()) {
    std::vector<std::string_view> tags;
    std::ranges::transform(kSteps, std::back_inserter(tags), &Step::tag);
    throw SceneError(step.where,
                     fmt::format("unknown element <{}>; a <transform> holds {}{}", shown(step.tag),
                                 fmt::join(tags, ", "), didYouMean(step.tag, tags)));
  }
  const auto& names = found->attributes;
  const auto count = std::ranges::find(names, std::string_view()) - names.begin();
  step.allowAttributes(std::span(names).first(static_cast<std::size_t>(count)));
  step.forbidChildren();
  return found->read(step);
}

void checkInvertible(const glm::dmat4& matrix, const SourceLocation& where) {
  // The determinant against the largest that columns of these lengths can have.
  const glm::dmat3 linear(matrix);
  const double most = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  constexpr double kLeastRatio = 1e-12;
  const double volume = std::abs(glm::determinant(linear));
  if (!std::isfinite(most) || !std::isfinite(glm::length(matrix[3]))) {
    throw SceneError(where, "the transform is not finite; give smaller numbers");
  }
  if (!(volume > kLeastRatio * most)) {
    throw SceneError(where, "the transform is singular: it flattens what it is applied to; "
                            "give scales that are not 0");
  }
}

} // namespace

glm::dmat4 readTransform(const XmlElement& transform) {
  const std::string* value = transform.find("value");
  if (value != nullptr && !transform.children.empty()) {
    throw SceneError(transform.where, "a transform with a value and with steps; give one of them");
  }
  glm::dmat4 matrix = value != nullptr ? matrixOf(*value, transform.where) : glm::dmat4(1.0);
  for (const XmlElement& step : transform.children) {
    matrix = readStep(step) * matrix;
  }
  checkInvertible(matrix, transform.where);
  return matrix;
}

} // namespace vkpt
