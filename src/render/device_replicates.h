#pragma once
#include "film/film.h"
#include "gpu/compute_pipeline.h"

#include <vector>

namespace vkpt {

/// Each pixel's mean in every replicate of a scrambled point set, in device memory: a texel buffer a channel,
/// dummies of one texel unless they are wanted. Of full groups of samples alone.
class DeviceReplicates {
public:
  /// Throws DeviceError when the size is beyond the device's limit for a texel buffer.
  DeviceReplicates(const gpu::Context& context, int width, int height, bool wanted);
  /// To another size, as if made anew: the caller binds it again.
  void resize(const gpu::Context& context, int width, int height);
  void bind(const gpu::Context& context, const gpu::BindingSet& bindings) const;
  void clear(const gpu::Context& context) const;
  /// Tells the moments of pixels [first, first + moments.size()) what the replicates differ by; does nothing
  /// unless wanted.
  void addTo(const gpu::Context& context, std::size_t first, std::span<PixelMoments> moments) const;
  [[nodiscard]] std::uint64_t bytes() const;

private:
  bool m_wanted;
  std::vector<gpu::TexelBuffer> m_means;
};

} // namespace vkpt
