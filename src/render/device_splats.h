#pragma once
#include "film/splats.h"
#include "gpu/compute_pipeline.h"

namespace vkpt {

/// Sums of what paths from the lights bring, in device memory; a dummy unless they are wanted.
class DeviceSplats {
public:
  /// Throws DeviceError when the size is beyond the device's limit for a texel buffer.
  DeviceSplats(const gpu::Context& context, int width, int height, bool wanted);
  /// To another size, as if made anew: the caller binds it again.
  void resize(const gpu::Context& context, int width, int height);
  void bind(const gpu::Context& context, const gpu::BindingSet& bindings, std::uint32_t binding) const;
  void clear(const gpu::Context& context) const;
  [[nodiscard]] bool wanted() const { return m_wanted; }
  /// Empty unless wanted.
  [[nodiscard]] SplatSums download(const gpu::Context& context) const;
  [[nodiscard]] std::uint64_t bytes() const { return m_numbers.bytes(); }
  /// Of a film of this size.
  [[nodiscard]] static std::uint64_t texelsFor(int width, int height) {
    return std::uint64_t{splatNumbers(width, height)} * 2;
  }

private:
  bool m_wanted;
  gpu::TexelBuffer m_numbers;
};

} // namespace vkpt
