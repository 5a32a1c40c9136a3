#include "film/splats.h"

#include "shared/structs.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace vkpt {
namespace {

constexpr std::size_t kPerPixel = shared::kSplatNumbers / 2;
constexpr std::size_t kParts = shared::kSplatParts;

std::size_t pixelsOf(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

} // namespace

std::size_t splatNumbers(int width, int height) { return pixelsOf(width, height) * kPerPixel + kParts * 3; }

SplatSums::SplatSums(int width, int height) : m_numbers(splatNumbers(width, height)) {}

void SplatSums::add(std::size_t number, std::uint64_t value) {
  std::atomic_ref(m_numbers[number]).fetch_add(value, std::memory_order_relaxed);
}

void SplatSums::addTo(PixelMoments& moments, std::size_t pixel, const SplatScale& scale, double frames,
                      double paths) const {
  if (moments.count == 0)
    return;
  for (int c = 0; c < 3; ++c) {
    const std::size_t at = pixel * kPerPixel + 2 * static_cast<std::size_t>(c);
    const double sum = static_cast<double>(m_numbers[at]) / static_cast<double>(scale.units);
    const double squares = static_cast<double>(m_numbers[at + 1]) / static_cast<double>(scale.squareUnits);
    moments.mean[c] += sum / frames;
    // Of a sum over paths of which few bring anything here. The two are rounded each by itself.
    moments.splatVariance[c] = std::max(squares - sum * sum / paths, 0.0) / (frames * frames);
  }
}

void SplatSums::addTo(Film& film, const SplatScale& scale) const {
  const std::size_t pixels = film.pixels.size();
  double paths = 0.0;
  std::array<double, kParts> pathsOf{};
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto count = static_cast<double>(film.pixels[i].count);
    paths += count;
    pathsOf[i % kParts] += count;
  }
  if (paths == 0.0)
    return;
  const double frames = paths / static_cast<double>(pixels);
  for (std::size_t i = 0; i < pixels; ++i)
    addTo(film.pixels[i], i, scale, frames, paths);
  const std::size_t parts = std::min(pixels, kParts);
  if (parts < 2)
    return;
  Vec3d variance(0.0);
  for (std::size_t c = 0; c < 3; ++c) {
    std::array<double, kParts> sums{};
    double whole = 0.0;
    for (std::size_t part = 0; part < parts; ++part) {
      sums[part] = static_cast<double>(m_numbers[pixels * kPerPixel + 3 * part + c]);
      whole += sums[part];
    }
    for (std::size_t part = 0; part < parts; ++part) {
      const double deviation =
          (sums[part] - whole * pathsOf[part] / paths) / static_cast<double>(scale.units);
      variance[static_cast<int>(c)] += deviation * deviation;
    }
  }
  const auto n = static_cast<double>(parts);
  film.splatVarianceOfMean = variance * (n / (n - 1.0)) / (paths * paths);
}

} // namespace vkpt
