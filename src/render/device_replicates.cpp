#include "render/device_replicates.h"

#include <algorithm>

namespace vkpt {
using namespace shared;

void addReplicates(PixelMoments& moments, const ReplicateMeans& means, std::size_t pixel) {
  // Samples of full groups, which belong to the replicates in turn.
  const std::uint64_t groups = moments.count / kSamplesPerGroup;
  const auto groupsOf = [groups](std::uint32_t replicate) {
    return static_cast<double>((groups + kReplicates - 1 - replicate) / kReplicates);
  };
  moments.replicates = static_cast<std::uint32_t>(std::min<std::uint64_t>(groups, kReplicates));
  for (int c = 0; c < 3; ++c) {
    const auto& m = means[static_cast<std::size_t>(c)][pixel];
    double sum = 0.0;
    for (std::uint32_t r = 0; r < moments.replicates; ++r)
      sum += groupsOf(r) * static_cast<double>(m[r]);
    const double mean = sum / static_cast<double>(groups);
    moments.between[c] = 0.0;
    for (std::uint32_t r = 0; r < moments.replicates; ++r) {
      const double deviation = static_cast<double>(m[r]) - mean;
      moments.between[c] += groupsOf(r) * kSamplesPerGroup * deviation * deviation;
    }
  }
}

DeviceReplicates::DeviceReplicates(const gpu::Context& context, int width, int height, bool wanted)
    : m_wanted(wanted) {
  const std::uint64_t pixels =
      wanted ? static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) : 1;
  for (int c = 0; c < 3; ++c)
    m_means.emplace_back(context, "means of replicates", pixels);
  clear(context);
}

void DeviceReplicates::resize(const gpu::Context& context, int width, int height) {
  if (m_wanted)
    *this = DeviceReplicates(context, width, height, true);
}

void DeviceReplicates::bind(const gpu::Context& context, const gpu::BindingSet& bindings) const {
  for (std::uint32_t c = 0; c < 3; ++c)
    bindings.bind(context, kBindingReplicates, m_means[c], c);
}

void DeviceReplicates::clear(const gpu::Context& context) const {
  for (const auto& means : m_means)
    means.buffer().fillZero(context);
}

ReplicateMeans DeviceReplicates::download(const gpu::Context& context, std::size_t first,
                                          std::size_t count) const {
  ReplicateMeans means;
  if (!m_wanted)
    return means;
  for (std::size_t c = 0; c < 3; ++c) {
    means[c].resize(count);
    m_means[c].buffer().read(context, std::as_writable_bytes(std::span{means[c]}),
                             first * sizeof(means[c][0]));
  }
  return means;
}

std::uint64_t DeviceReplicates::bytes() const { return gpu::bytesOf(m_means); }

} // namespace vkpt
