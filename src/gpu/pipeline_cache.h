#pragma once
// Compiled pipelines on disk, one file for each kernel, set of constants, device and driver.

#include "gpu/context.h"
#include "gpu/specialised.h"

#include <span>

namespace vkpt::gpu {

/// What tells a kernel with these constants on this device and driver from all others.
std::uint64_t pipelineKey(const Context& context, std::span<const std::uint32_t> spirv,
                          const SpecialisationMap& constants);

/// What a driver compiled before, as far as the context has a cache folder and it can be used: a file that is
/// missing, corrupt or another driver's counts for nothing, and a folder that can't be written is left alone.
class PipelineCache {
public:
  PipelineCache(const Context& context, std::uint64_t pipelineKey);
  /// Null without a folder.
  [[nodiscard]] vk::Optional<const vk::raii::PipelineCache> handle() const {
    return m_file.empty() ? vk::Optional<const vk::raii::PipelineCache>(nullptr) : m_cache;
  }
  /// Writes what the driver has now, unless that is what was read.
  void save() const;

private:
  std::filesystem::path m_file; ///< empty: no cache
  std::uint64_t m_key = 0;
  std::vector<std::uint8_t> m_read; ///< what the file held
  vk::raii::PipelineCache m_cache = nullptr;
};

} // namespace vkpt::gpu
