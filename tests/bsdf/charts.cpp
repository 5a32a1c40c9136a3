#include "bsdf/charts.h"

#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

namespace vkpt::test {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

struct Axes {
  Vec3d x, y, z;
};
/// x towards `side` where it is not along z.
Axes axesAbout(const Vec3d& z, const Vec3d& side) {
  Vec3d across = side - z * glm::dot(side, z);
  if (glm::length(across) < 1e-6) {
    const Vec3d other = std::abs(z.x) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    across = other - z * glm::dot(other, z);
  }
  const Vec3d x = glm::normalize(across);
  return {x, glm::cross(z, x), z};
}

/// [0, 1) to [0, infinity), 1/2 to `width`; and back.
double stretched(double u, double width) { return width * u / (1.0 - u); }
double squeezed(double r, double width) { return r / (r + width); }

double turnOf(double x, double y) {
  const double turn = std::atan2(y, x) / kTurn;
  return turn < 0.0 ? turn + 1.0 : turn;
}

Vec3d facet(const Axes& axes, double u, double v, double alpha) {
  const double r = stretched(u, alpha);
  return glm::normalize(axes.x * (r * std::cos(kTurn * v)) + axes.y * (r * std::sin(kTurn * v)) + axes.z);
}
Vec2d facetPosition(const Axes& axes, const Vec3d& h, double alpha) {
  const double cosine = glm::dot(h, axes.z);
  const double x = glm::dot(h, axes.x) / cosine;
  const double y = glm::dot(h, axes.y) / cosine;
  return {squeezed(std::hypot(x, y), alpha), turnOf(x, y)};
}

} // namespace

double Chart::jacobian(double u, double v) const {
  constexpr double kStep = 1e-6;
  const auto difference = [&](double du, double dv) {
    const auto here = direction(u, v);
    const auto after = direction(u + du, v + dv);
    const auto before = direction(u - du, v - dv);
    const double steps = (after ? kStep : 0.0) + (before ? kStep : 0.0);
    return steps > 0.0 ? (after.value_or(*here) - before.value_or(*here)) / steps : Vec3d(0.0);
  };
  return glm::length(glm::cross(difference(kStep, 0.0), difference(0.0, kStep)));
}

Chart polarChart(const Vec3d& axis, const Vec3d& n, double width) {
  const Axes axes = axesAbout(axis, n);
  const double half = std::tan(0.5 * width);
  Chart chart;
  chart.direction = [=](double u, double v) -> std::optional<Vec3d> {
    const double theta = 2.0 * std::atan(stretched(u, half));
    const double s = std::sin(theta);
    const Vec3d d =
        axes.x * (s * std::cos(kTurn * v)) + axes.y * (s * std::sin(kTurn * v)) + axes.z * std::cos(theta);
    if (glm::dot(d, n) <= 0.0)
      return {};
    return d;
  };
  chart.locate = [=](const Vec3d& d) -> std::optional<Vec2d> {
    if (glm::dot(d, n) <= 0.0)
      return {};
    const double x = glm::dot(d, axes.x);
    const double y = glm::dot(d, axes.y);
    const double theta = std::atan2(std::hypot(x, y), glm::dot(d, axes.z));
    return Vec2d(squeezed(std::tan(0.5 * theta), half), turnOf(x, y));
  };
  return chart;
}

Chart reflectionChart(const Vec3d& wo, const Vec3d& n, double alpha) {
  const Axes axes = axesAbout(n, wo);
  Chart chart;
  chart.direction = [=](double u, double v) -> std::optional<Vec3d> {
    const Vec3d h = facet(axes, u, v, alpha);
    const double cosine = glm::dot(wo, h);
    const Vec3d d = h * (2.0 * cosine) - wo;
    if (cosine <= 0.0 || glm::dot(d, n) <= 0.0)
      return {};
    return d;
  };
  chart.locate = [=](const Vec3d& d) -> std::optional<Vec2d> {
    if (glm::dot(d, n) <= 0.0)
      return {};
    return facetPosition(axes, wo + d, alpha);
  };
  return chart;
}

Chart refractionChart(const Vec3d& wo, const Vec3d& n, double alpha, double eta) {
  const Axes axes = axesAbout(n, wo);
  Chart chart;
  chart.direction = [=](double u, double v) -> std::optional<Vec3d> {
    const Vec3d h = facet(axes, u, v, alpha);
    const double cosine = glm::dot(wo, h);
    const double cos2 = 1.0 - (1.0 - cosine * cosine) / (eta * eta);
    if (cosine <= 0.0 || cos2 <= 0.0)
      return {};
    const Vec3d d = h * (cosine / eta - std::sqrt(cos2)) - wo / eta;
    if (glm::dot(d, n) >= 0.0)
      return {};
    return d;
  };
  chart.locate = [=](const Vec3d& d) -> std::optional<Vec2d> {
    if (glm::dot(d, n) >= 0.0)
      return {};
    return facetPosition(axes, wo + d * eta, alpha);
  };
  return chart;
}

} // namespace vkpt::test
