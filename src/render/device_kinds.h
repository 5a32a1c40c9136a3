#pragma once
#include "gpu/compute_pipeline.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace vkpt {

/// The images of the kinds of light path, in device memory: a buffer of kKindPlanes planes for each kind,
/// dummies of one pixel unless they are wanted.
class DeviceKinds {
public:
  /// Throws UsageError when the size is beyond the device's limit for a storage buffer.
  DeviceKinds(const gpu::Context& context, int width, int height, bool wanted);
  /// To another size, as if made anew: the caller binds it again.
  void resize(const gpu::Context& context, int width, int height);
  void bind(const gpu::Context& context, const gpu::BindingSet& bindings) const;
  void clear(const gpu::Context& context) const;
  /// Mean radiance of each kind, given the samples of each pixel; empty unless wanted.
  [[nodiscard]] std::vector<std::vector<Vec3d>> download(const gpu::Context& context,
                                                         std::span<const std::uint64_t> samples) const;
  [[nodiscard]] std::uint64_t bytes() const;

private:
  std::size_t m_pixels;
  bool m_wanted;
  std::vector<gpu::Buffer> m_images;
};

} // namespace vkpt
