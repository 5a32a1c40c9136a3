#pragma once
#include "film/film.h"
#include "gpu/compute_pipeline.h"

#include <vector>

namespace vkpt {

/// The film in device memory: planes of 32-bit values, kFilmPlanes of them.
class DeviceFilm {
public:
  /// Throws UsageError when the size is beyond the device's limit for a storage buffer.
  DeviceFilm(const gpu::Context& context, int width, int height);
  void bind(const gpu::Context& context, const gpu::BindingSet& bindings) const;
  void clear(const gpu::Context& context) const;
  /// Reads the planes back and joins each pixel's open group to its closed ones.
  [[nodiscard]] Film download(const gpu::Context& context) const;
  [[nodiscard]] std::uint64_t bytes() const;

private:
  int m_width;
  int m_height;
  std::vector<gpu::Buffer> m_planes;
};

} // namespace vkpt
