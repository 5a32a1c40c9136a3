#pragma once
// The device memory that a render takes, against what the device has.

#include "device/effects.h"
#include "device/packed_scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace vkpt::gpu {
class Context;
}

namespace vkpt {

/// Of `slots` paths that are under way at once, in bytes.
std::uint64_t pathStateBytes(std::uint32_t slots, std::uint32_t splitDepth, bool lightTree);
std::uint64_t slotListBytes(std::uint32_t slots);

struct MemoryRow {
  std::string_view what;
  std::uint64_t bytes = 0;
  std::uint64_t largestBuffer = 0; ///< bytes of the largest of its buffers
  std::string_view limit;          ///< the device's name for what a buffer may take at most
  std::uint64_t limitBytes = 0;
};

struct MemoryPlan {
  std::vector<MemoryRow> rows;
  std::uint64_t heapBytes = 0; ///< of the device's largest heap
  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] bool fits() const;
};

/// `tileBlocks`: blocks in a unit of work, 0: as many as there may be.
MemoryPlan planMemory(const gpu::Context& context, const PackedScene& packed, const EffectSet& effects,
                      const EstimatorSettings& estimator, int width, int height,
                      std::uint32_t tileBlocks = 0);

/// What an effect's own buffers take of it, in bytes.
std::uint64_t effectBytes(Effect effect, const PackedScene& packed, const EffectSet& effects,
                          const EstimatorSettings& estimator, int width, int height,
                          std::uint32_t tileBlocks = 0);

} // namespace vkpt
