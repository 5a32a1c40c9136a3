#include "film/tail.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace vkpt {
namespace {

// Hill's estimate takes a small share of the largest values, and enough of them for a standard error of a
// fifth.
constexpr std::size_t kLeast = 25;
constexpr std::size_t kShare = 500;

/// Infinite where not known, so that the pixel and its neighbours are left out.
double sampleVariance(const PixelMoments& p) {
  const double m2 = p.m2.x + p.m2.y + p.m2.z;
  return p.count >= 2 && std::isfinite(m2) ? m2 / static_cast<double>(p.count - 1) : INFINITY;
}

/// Of the eight pixels about (x, y), which is not at the image's border.
double secondLargestAbout(const std::vector<double>& values, std::size_t width, std::size_t x,
                          std::size_t y) {
  double largest = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < 9; ++i) {
    if (i == 4)
      continue;
    const double v = values[(y + i / 3 - 1) * width + x + i % 3 - 1];
    second = std::max(second, std::min(v, largest));
    largest = std::max(largest, v);
  }
  return second;
}

std::vector<double> relativeVariances(const Film& film) {
  const auto width = static_cast<std::size_t>(film.width);
  const auto height = static_cast<std::size_t>(film.height);
  std::vector<double> variances;
  variances.reserve(film.pixels.size());
  for (const PixelMoments& p : film.pixels)
    variances.push_back(sampleVariance(p));
  std::vector<double> relative;
  for (std::size_t y = 1; y + 1 < height; ++y) {
    for (std::size_t x = 1; x + 1 < width; ++x) {
      const double about = secondLargestAbout(variances, width, x, y);
      const double ratio = variances[y * width + x] / about;
      if (about > 0.0 && std::isfinite(about) && std::isfinite(ratio))
        relative.push_back(ratio);
    }
  }
  return relative;
}

} // namespace

std::optional<TailEstimate> estimateTail(const Film& film) {
  std::vector<double> values = relativeVariances(film);
  const std::size_t k = std::max(kLeast, values.size() / kShare);
  if (values.size() < 20 * kLeast)
    return std::nullopt;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(k), std::greater{});
  const double threshold = values[k];
  double logs = 0.0;
  for (std::size_t i = 0; i < k; ++i)
    logs += std::log(values[i] / threshold);
  if (!(threshold > 0.0 && logs > 0.0))
    return std::nullopt;
  const double index = 2.0 * static_cast<double>(k) / logs;
  return TailEstimate{index, index / std::sqrt(static_cast<double>(k))};
}

} // namespace vkpt
