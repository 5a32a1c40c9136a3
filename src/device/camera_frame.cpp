#include "device/camera_frame.h"

#include "core/error.h"
#include "device/filter_table.h"
#include "device/light_table.h"
#include "device/light_tracing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vkpt {
namespace {

shared::vec4 toVec4(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0.0F};
}

std::uint32_t blocksAlong(int pixels) {
  return (static_cast<std::uint32_t>(pixels) + shared::kBlockEdge - 1) / shared::kBlockEdge;
}

// What can still become of a path by its history (shaders/lib/kinds.glsl), a bit a kind.
constexpr std::uint32_t bit(std::uint32_t kind) { return 1U << kind; }
constexpr std::uint32_t kBehindS = bit(shared::kKindCaustic) | bit(shared::kKindIndirectCaustic);
constexpr std::uint32_t kBehindD = bit(shared::kKindIndirect) | kBehindS;
constexpr std::array<std::uint32_t, 8> kWithinReach{
    kAllPathKinds,
    kAllPathKinds & ~bit(shared::kKindEmission),
    kBehindD | bit(shared::kKindDirect),
    bit(shared::kKindIndirect) | bit(shared::kKindIndirectCaustic),
    kBehindS,
    kBehindS,
    kBehindS,
    bit(shared::kKindIndirectCaustic),
};

std::uint32_t deadHistories(std::uint32_t pathKinds) {
  std::uint32_t dead = 0;
  for (std::uint32_t history = 0; history < kWithinReach.size(); ++history)
    dead |= (kWithinReach[history] & pathKinds) == 0 ? 1U << history : 0U;
  return dead;
}

/// By what a path from a light would bring to a pixel from the scene's far end, by way of a white surface:
/// `typical`. Sums may be 2^40 of these, those of squares 2^48 of its square; what is rounded is 2^-24 and
/// 2^-16 of them.
void setSplatUnits(shared::FrameConstants& constants, const Scene& scene) {
  if (constants.tracesLights == 0)
    return; // no walk over the scene whenever the camera moves
  Box3d box;
  for (const Vec3f& p : scene.positions)
    box.extend(Vec3d(p) + scene.origin);
  box.extend(scene.camera.eye);
  const Vec3d extent = box.extent();
  const double area = static_cast<double>(constants.forward.w);
  const double typical = static_cast<double>(constants.lightPower) / (glm::dot(extent, extent) * area);
  const double units = typical > 0.0 ? std::exp2(24.0 - std::round(std::log2(typical))) : 1.0;
  constants.splatUnits = static_cast<float>(units);
  constants.splatSquareUnits = static_cast<float>(units * units * std::exp2(-32.0));
}

/// Of points all over the sides of a box.
float uniformPdf_A(const Box3d& box) {
  const Vec3d e = box.extent();
  const double area = 2.0 * (e.x * e.y + e.y * e.z + e.z * e.x);
  return area > 0.0 ? static_cast<float>(1.0 / area) : 1.0F;
}

/// In local coordinates, a little too large: rounding must not make a path miss one.
void setSpecularBoxes(shared::FrameConstants& constants, const Scene& scene) {
  constexpr float kNowhere = 1e30F;
  std::ranges::fill(constants.specularLower, shared::vec4{kNowhere, kNowhere, kNowhere, 0.0F});
  std::ranges::fill(constants.specularUpper, shared::vec4{kNowhere, kNowhere, kNowhere, 0.0F});
  if (constants.tracesLights == 0)
    return;
  std::size_t i = 0;
  for (const Box3d& box : specularBoxes(scene, shared::kSpecularBoxes)) {
    const Vec3d margin(1e-5 * std::max(glm::length(box.lower), glm::length(box.upper)));
    constants.specularLower[i] = toVec4(box.lower - margin);
    constants.specularUpper[i] = toVec4(box.upper + margin);
    ++i;
  }
}

} // namespace

void setView(shared::FrameConstants& constants, const Scene& scene, int width, int height) {
  const Camera& c = scene.camera;
  const Vec3d view = c.target - c.eye;
  const Vec3d side = glm::cross(view, c.up);
  if (!(glm::length(view) > 0.0))
    throw UsageError("the camera's eye and target are the same point");
  if (!(glm::length(side) > 1e-9 * glm::length(view) * glm::length(c.up))) {
    throw UsageError("the camera's up vector is parallel to its view; give another --up");
  }
  if (!(c.fovDegrees > 0.0 && c.fovDegrees < 180.0)) {
    throw UsageError(
        fmt::format("a field of view of {} degrees; it must lie between 0 and 180", c.fovDegrees));
  }
  const double extent = 2.0 * std::tan(0.5 * c.fovDegrees * std::numbers::pi / 180.0);
  const double aspect = static_cast<double>(width) / static_cast<double>(height);
  const bool horizontal = c.fovAxis == Camera::FovAxis::Horizontal;
  const Vec3d forward = glm::normalize(view);
  const double handedness = c.mirrored ? -1.0 : 1.0;
  const Vec3d right = glm::normalize(side) * (handedness * (horizontal ? extent : extent * aspect));
  const Vec3d down = glm::normalize(glm::cross(forward, side)) * (horizontal ? extent / aspect : extent);
  constants.eye = toVec4(c.eye - scene.origin);
  constants.upperLeft = toVec4(forward - 0.5 * right - 0.5 * down);
  constants.right = toVec4(right);
  constants.down = toVec4(down);
  constants.forward = toVec4(forward);
  constants.forward.w = static_cast<float>(glm::length(right) * glm::length(down));
  setSplatUnits(constants, scene);
  constants.width = static_cast<std::uint32_t>(width);
  constants.height = static_cast<std::uint32_t>(height);
  constants.blocksX = blocksAlong(width);
  constants.blocksPerStripe =
      (constants.blocksX * blocksAlong(height) + shared::kStripes - 1) / shared::kStripes;
}

shared::FrameConstants frameConstants(const Scene& scene, const LightChoice& lights,
                                      const EstimatorSettings& estimator, int width, int height,
                                      std::uint32_t seed) {
  const auto obstacle = lightTracingObstacle(scene, estimator);
  if (estimator.lightTracing == LightTracing::On && obstacle && obstacle->impossible)
    throw UsageError("--light-tracing on can't go together with " + obstacle->reason.text());
  if (const auto reuse = pathReuseObstacle(estimator))
    throw UsageError(fmt::format("--path-reuse {} can't go together with {}", estimator.pathReuse, *reuse));
  shared::FrameConstants c{};
  c.tracesLights = obstacle ? 0U : 1U;
  c.lightPower = static_cast<float>(lights.totalPower);
  setView(c, scene, width, height);
  setSpecularBoxes(c, scene);
  c.background = {scene.background.x, scene.background.y, scene.background.z, 0.0F};
  c.seed = seed;
  c.lightCount = lights.count;
  c.environmentProbability = lights.environmentProbability;
  c.lightGridLower = toVec4(Vec3d(lights.grid.lower));
  c.lightGridLower.w = lights.grid.cubesPerMetre;
  c.guideLower = toVec4(Vec3d(lights.guide.lower));
  c.guideLower.w = lights.guide.cubesPerMetre;
  c.guideGridEdge = lights.guide.edge;
  c.environmentLeaf = lights.environmentLeaf;
  c.environmentWidth = static_cast<std::uint32_t>(scene.environment.width);
  c.environmentHeight = static_cast<std::uint32_t>(scene.environment.height);
  c.maxBounces = estimator.maxBounces;
  c.rouletteAfter = estimator.effectiveRouletteAfter();
  c.survival = static_cast<float>(1.0 - estimator.termination);
  c.lightStrategy = static_cast<std::uint32_t>(estimator.light);
  c.lightSamples = estimator.lightSamples;
  c.splitDepth = estimator.splitDepth;
  c.specularSamples = estimator.specularSamples;
  if (estimator.pathReuse > 1 && c.tracesLights != 0)
    c.sharedEyePdf_A = uniformPdf_A(sceneBox(scene));
  c.pathKinds = estimator.pathKinds;
  c.deadHistories = deadHistories(estimator.pathKinds);
  setFilter(c, scene.filter);
  return c;
}

} // namespace vkpt
