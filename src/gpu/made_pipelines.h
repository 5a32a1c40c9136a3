#pragma once
// Pipelines that a process has made, kept for the next who needs the same.

#include <vulkan/vulkan_raii.hpp>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace vkpt::gpu {

/// The few that were used last: renders of one kernel follow each other, as in a self-test or a study, and a
/// driver needs a third of a second for each.
class MadePipelines {
public:
  using Pipeline = std::shared_ptr<const vk::raii::Pipeline>;

  /// Null where there is none of this key.
  [[nodiscard]] Pipeline find(std::uint64_t key);
  void keep(std::uint64_t key, Pipeline pipeline);

private:
  std::vector<std::pair<std::uint64_t, Pipeline>> m_pipelines; ///< the one used last stands last
};

} // namespace vkpt::gpu
