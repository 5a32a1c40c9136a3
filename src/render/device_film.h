#pragma once
#include "film/film.h"
#include "gpu/compute_pipeline.h"
#include "shared/structs.h"

#include <vector>

namespace vkpt {

/// What is read back from device memory: values by plane, each of so many pixels.
using FilmPlanes = std::vector<std::vector<std::uint32_t>>;
/// Each pixel's open group joined to its closed ones.
PixelMoments momentsAt(const FilmPlanes& planes, std::size_t pixel);

/// The film in device memory: planes of 32-bit values, kFilmPlanes of them.
class DeviceFilm {
public:
  /// Throws UsageError when the size is beyond the device's limit for a storage buffer.
  DeviceFilm(const gpu::Context& context, int width, int height);
  /// To another size, as if made anew, but for memory that is large enough already: the caller binds it
  /// again.
  void resize(const gpu::Context& context, int width, int height);
  void bind(const gpu::Context& context, const gpu::BindingSet& bindings,
            std::uint32_t binding = shared::kBindingFilm) const;
  void clear(const gpu::Context& context) const;
  /// Pixels [first, first + count), row by row.
  [[nodiscard]] FilmPlanes download(const gpu::Context& context, std::size_t first, std::size_t count) const;
  [[nodiscard]] std::uint64_t bytes() const;

private:
  [[nodiscard]] std::uint64_t planeBytes() const;

  int m_width = 0;
  int m_height = 0;
  std::vector<gpu::Buffer> m_planes;
};

} // namespace vkpt
