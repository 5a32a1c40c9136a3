#pragma once
#include "film/film.h"
#include "gpu/compute_pipeline.h"
#include "shared/structs.h"

#include <array>
#include <vector>

namespace vkpt {

/// What is read back: by channel and pixel the mean in each replicate; empty where there are none.
using ReplicateMeans = std::array<std::vector<std::array<float, shared::kReplicates>>, 3>;
/// Tells a pixel's moments what the replicates differ by.
void addReplicates(PixelMoments& moments, const ReplicateMeans& means, std::size_t pixel);

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
  /// Pixels [first, first + count), row by row; empty unless wanted.
  [[nodiscard]] ReplicateMeans download(const gpu::Context& context, std::size_t first,
                                        std::size_t count) const;
  [[nodiscard]] std::uint64_t bytes() const;

private:
  bool m_wanted;
  std::vector<gpu::TexelBuffer> m_means;
};

} // namespace vkpt
