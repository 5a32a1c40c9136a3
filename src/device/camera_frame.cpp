#include "device/camera_frame.h"

#include "core/error.h"
#include "device/filter_table.h"

#include <fmt/format.h>

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
  constants.width = static_cast<std::uint32_t>(width);
  constants.height = static_cast<std::uint32_t>(height);
  constants.blocksX = blocksAlong(width);
  constants.blocksPerStripe =
      (constants.blocksX * blocksAlong(height) + shared::kStripes - 1) / shared::kStripes;
}

shared::FrameConstants frameConstants(const Scene& scene, const LightChoice& lights,
                                      const EstimatorSettings& estimator, int width, int height,
                                      std::uint32_t seed) {
  shared::FrameConstants c{};
  setView(c, scene, width, height);
  c.background = {scene.background.x, scene.background.y, scene.background.z, 0.0F};
  c.seed = seed;
  c.lightCount = lights.count;
  c.environmentProbability = lights.environmentProbability;
  c.environmentWidth = static_cast<std::uint32_t>(scene.environment.width);
  c.environmentHeight = static_cast<std::uint32_t>(scene.environment.height);
  c.maxBounces = estimator.maxBounces;
  c.rouletteAfter = estimator.effectiveRouletteAfter();
  c.survival = static_cast<float>(1.0 - estimator.termination);
  c.lightStrategy = static_cast<std::uint32_t>(estimator.light);
  c.lightSamples = estimator.lightSamples;
  c.splitDepth = estimator.splitDepth;
  c.pathKinds = estimator.pathKinds;
  c.deadHistories = deadHistories(estimator.pathKinds);
  setFilter(c, scene.filter);
  return c;
}

} // namespace vkpt
