#include "render/memory_plan.h"

#include "render/device_reuse.h"
#include "render/device_splats.h"
#include "render/render_job.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace vkpt {
namespace {

using namespace shared;

template<class T>
std::uint64_t sizeOf(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

std::uint64_t pixelsOf(int width, int height) {
  return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

std::uint64_t splatBytes(int width, int height) {
  return DeviceSplats::texelsFor(width, height) * sizeof(std::uint32_t);
}

/// As the integrator reserves them for the largest tile.
std::uint32_t slotsFor(int width, int height, std::uint32_t tileBlocks) {
  const auto along = [](int pixels) {
    return (static_cast<std::uint64_t>(pixels) + kBlockEdge - 1) / kBlockEdge;
  };
  const std::uint64_t stripes = (along(width) * along(height) + kStripes - 1) / kStripes;
  const std::uint64_t most = tileBlocks > 0 ? tileBlocks : kMostTileBlocks;
  return std::bit_ceil(static_cast<std::uint32_t>(std::min(stripes * kStripes, most)) * kBlockPixels);
}

/// What pixels share of their paths, at most.
struct SharedBytes {
  std::uint64_t paths;
  std::uint64_t connections;
};
SharedBytes sharedBytes(std::uint32_t slots, const EffectSet& effects, const EstimatorSettings& estimator) {
  const std::uint64_t shared = std::min<std::uint64_t>(slots, kMostSharedBlocks * kBlockPixels);
  return {DeviceReuse::pathBytes(shared, kSamplesPerGroup, effects.has(Effect::LightTree)),
          DeviceReuse::connectionBytes(shared, kSamplesPerGroup, estimator.reuseEdge())};
}

} // namespace

std::uint64_t pathStateBytes(std::uint32_t slots, std::uint32_t splitDepth, bool lightTree) {
  const std::uint32_t planes = kPathPlanes + splitDepth * kBranchPlanes + (lightTree ? kVertexPlanes : 0U);
  return std::uint64_t{slots} * planes * sizeof(Texel);
}

std::uint64_t slotListBytes(std::uint32_t slots) {
  return std::uint64_t{slots} * 2 * sizeof(std::uint32_t); // two lists in turn
}

std::uint64_t MemoryPlan::bytes() const {
  return std::accumulate(rows.begin(), rows.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const MemoryRow& row) { return sum + row.bytes; });
}

bool MemoryPlan::fits() const {
  return bytes() <= heapBytes &&
         std::ranges::all_of(rows, [](const MemoryRow& row) { return row.largestBuffer <= row.limitBytes; });
}

MemoryPlan planMemory(const gpu::Context& context, const PackedScene& packed, const EffectSet& effects,
                      const EstimatorSettings& estimator, int width, int height, std::uint32_t tileBlocks) {
  MemoryPlan plan;
  plan.heapBytes = context.largestHeap();
  const auto texels = [&](std::string_view what, std::uint64_t bytes) {
    plan.rows.push_back({what, bytes, bytes, "maxTexelBufferElements",
                         std::uint64_t{context.limits().maxTexelBufferElements} * sizeof(Texel)});
  };
  const auto numbers = [&](std::string_view what, std::uint64_t bytes) {
    plan.rows.push_back({what, bytes, bytes, "maxTexelBufferElements",
                         std::uint64_t{context.limits().maxTexelBufferElements} * sizeof(std::uint32_t)});
  };
  const auto storage = [&](std::string_view what, std::uint64_t buffers, std::uint64_t bytes) {
    plan.rows.push_back(
        {what, buffers * bytes, bytes, "maxStorageBufferRange", context.limits().maxStorageBufferRange});
  };
  texels("BVH nodes", packed.bvh.nodes.size() * sizeof(BvhNode));
  texels("triangles", sizeOf(packed.triangles));
  texels("normals", sizeOf(packed.normals));
  texels("materials", sizeOf(packed.materials));
  texels("lights", sizeOf(packed.lights));
  texels("light tree", sizeOf(packed.lightNodes));
  texels("texture coordinates", sizeOf(packed.uvs));
  texels("textures", sizeOf(packed.textures));
  texels("environment", sizeOf(packed.environment));
  numbers("guided directions", sizeOf(packed.guide));
  numbers("grid of lights", sizeOf(packed.lightGrid));
  const std::uint64_t pixels = pixelsOf(width, height);
  const std::uint32_t slots = slotsFor(width, height, tileBlocks);
  constexpr std::uint64_t kSmallestBuffer = 16;
  storage("film", kFilmPlanes, std::max(kSmallestBuffer, pixels * sizeof(std::uint32_t)));
  storage("kinds of light path", kKindCount,
          (effects.has(Effect::KindImages) ? pixels : 1) * kKindPlanes * sizeof(float));
  texels("means of replicates", 3 * (estimator.sampler == Sampler::Sobol ? pixels : 1) * sizeof(Texel));
  if (effects.has(Effect::LightTracing))
    numbers("splats", splatBytes(width, height));
  storage("path states, at most", 1,
          pathStateBytes(slots, estimator.splitDepth, effects.has(Effect::LightTree)));
  if (effects.has(Effect::PathReuse)) {
    const SharedBytes shared = sharedBytes(slots, effects, estimator);
    texels("shared paths, at most", shared.paths);
    texels("connections, at most", shared.connections);
  }
  storage("slot lists, at most", 1, slotListBytes(slots));
  return plan;
}

std::uint64_t effectBytes(Effect effect, const PackedScene& packed, const EffectSet& effects,
                          const EstimatorSettings& estimator, int width, int height,
                          std::uint32_t tileBlocks) {
  if (!effects.has(effect))
    return 0;
  constexpr std::uint64_t kLight = kTexelsPerLight * sizeof(Texel);
  const std::uint32_t slots = slotsFor(width, height, tileBlocks);
  switch (effect) {
  case Effect::SmoothNormals:
    return sizeOf(packed.normals);
  case Effect::Textures:
    return sizeOf(packed.uvs) + sizeOf(packed.textures);
  case Effect::LightSampling:
    return kLight;
  case Effect::ManyLights:
    return sizeOf(packed.lights) - kLight;
  case Effect::Environment:
    return sizeOf(packed.environment);
  case Effect::Splitting:
    return pathStateBytes(slots, estimator.splitDepth, false) - pathStateBytes(slots, 0, false);
  case Effect::LightTree:
    return sizeOf(packed.lightNodes) + sizeOf(packed.lightGrid) + pathStateBytes(slots, 0, true) -
           pathStateBytes(slots, 0, false);
  case Effect::PathReuse: {
    const SharedBytes shared = sharedBytes(slots, effects, estimator);
    return shared.paths + shared.connections;
  }
  case Effect::Guiding:
    return sizeOf(packed.guide);
  case Effect::LightTracing:
    return splatBytes(width, height);
  case Effect::KindImages:
    return pixelsOf(width, height) * kKindCount * kKindPlanes * sizeof(float);
  default:
    return 0;
  }
}

} // namespace vkpt
