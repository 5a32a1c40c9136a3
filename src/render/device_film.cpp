#include "render/device_film.h"

#include "core/error.h"
#include "shared/structs.h"

#include <fmt/format.h>

#include <bit>

namespace vkpt {
namespace {

double pairAt(const FilmPlanes& planes, std::uint32_t plane, std::size_t pixel) {
  return static_cast<double>(std::bit_cast<float>(planes[plane][pixel])) +
         static_cast<double>(std::bit_cast<float>(planes[plane + 1][pixel]));
}

} // namespace

PixelMoments momentsAt(const FilmPlanes& planes, std::size_t pixel) {
  using namespace shared;
  const std::uint32_t count = planes[kFilmCount][pixel];
  PixelMoments closed;
  PixelMoments open;
  open.count = count % kSamplesPerGroup;
  closed.count = count - open.count;
  for (std::uint32_t c = 0; c < 3; ++c) {
    const auto i = static_cast<int>(c);
    closed.mean[i] = pairAt(planes, kFilmMean + 2 * c, pixel);
    closed.m2[i] = pairAt(planes, kFilmDeviations + 2 * c, pixel);
    open.mean[i] = std::bit_cast<float>(planes[kFilmOpenMean + c][pixel]);
    open.m2[i] = std::bit_cast<float>(planes[kFilmOpenDeviations + c][pixel]);
  }
  closed.merge(open);
  return closed;
}

DeviceFilm::DeviceFilm(const gpu::Context& context, int width, int height) { resize(context, width, height); }

std::uint64_t DeviceFilm::planeBytes() const {
  return static_cast<std::uint64_t>(m_width) * static_cast<std::uint64_t>(m_height) * sizeof(std::uint32_t);
}

void DeviceFilm::resize(const gpu::Context& context, int width, int height) {
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  const std::uint64_t limit = context.limits().maxStorageBufferRange / sizeof(std::uint32_t);
  if (pixels > limit) {
    throw UsageError(fmt::format("--size {}x{}: {} pixels; {} can do {} at most", width, height, pixels,
                                 context.info().name, limit));
  }
  const std::uint64_t need = pixels * sizeof(std::uint32_t) * shared::kFilmPlanes;
  if (need > context.largestHeap()) {
    throw UsageError(fmt::format("--size {}x{}: the film needs {:.0f} MB; {} has {:.0f} MB", width, height,
                                 static_cast<double>(need) * 1e-6, context.info().name,
                                 static_cast<double>(context.largestHeap()) * 1e-6));
  }
  m_width = width;
  m_height = height;
  if (m_planes.empty() || m_planes.front().bytes() < planeBytes()) {
    m_planes.clear();
    for (std::uint32_t i = 0; i < shared::kFilmPlanes; ++i) {
      m_planes.emplace_back(context, "film plane", planeBytes(), vk::BufferUsageFlagBits::eStorageBuffer,
                            gpu::MemoryKind::Device);
    }
  }
  clear(context);
}

void DeviceFilm::bind(const gpu::Context& context, const gpu::BindingSet& bindings,
                      std::uint32_t binding) const {
  for (std::uint32_t i = 0; i < shared::kFilmPlanes; ++i) {
    bindings.bind(context, binding, m_planes[i], vk::DescriptorType::eStorageBuffer, i);
  }
}

void DeviceFilm::clear(const gpu::Context& context) const {
  for (const auto& plane : m_planes)
    plane.fillZero(context, planeBytes());
}

FilmPlanes DeviceFilm::download(const gpu::Context& context, std::size_t first, std::size_t count) const {
  FilmPlanes planes(shared::kFilmPlanes, std::vector<std::uint32_t>(count));
  for (std::size_t i = 0; i < planes.size(); ++i)
    m_planes[i].read(context, std::as_writable_bytes(std::span{planes[i]}), first * sizeof(std::uint32_t));
  return planes;
}

std::uint64_t DeviceFilm::bytes() const { return gpu::bytesOf(m_planes); }

} // namespace vkpt
