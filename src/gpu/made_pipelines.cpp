#include "gpu/made_pipelines.h"

#include <algorithm>

namespace vkpt::gpu {
namespace {

constexpr std::size_t kMostKept = 16; // each takes the driver a few MB

} // namespace

MadePipelines::Pipeline MadePipelines::find(std::uint64_t key) {
  const auto found = std::ranges::find(m_pipelines, key, &decltype(m_pipelines)::value_type::first);
  if (found == m_pipelines.end())
    return nullptr;
  std::rotate(found, found + 1, m_pipelines.end());
  return m_pipelines.back().second;
}

void MadePipelines::keep(std::uint64_t key, Pipeline pipeline) {
  if (m_pipelines.size() == kMostKept)
    m_pipelines.erase(m_pipelines.begin());
  m_pipelines.emplace_back(key, std::move(pipeline));
}

} // namespace vkpt::gpu
