#include "film/film.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace vkpt {

void PixelMoments::merge(const PixelMoments& other) {
  if (other.count == 0)
    return;
  if (count == 0) {
    *this = other;
    return;
  }
  const auto here = static_cast<double>(count), there = static_cast<double>(other.count);
  const Vec3d delta = other.mean - mean;
  const double share = there / (here + there);
  mean += delta * share;
  m2 += other.m2 + delta * delta * (here * share);
  count += other.count;
}

Vec3d PixelMoments::varianceOfMean() const {
  if (count < 2)
    return Vec3d(0.0);
  const auto n = static_cast<double>(count);
  return m2 / (n * (n - 1.0));
}

namespace {

bool isFinite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool isFinite(const PixelMoments& p) { return isFinite(p.mean) && isFinite(p.m2); }
bool isMeasured(const PixelMoments& p) { return p.count > 0 && isFinite(p); }

constexpr double kNormal95 = 1.6448536269514722; // 95 % quantile of the normal distribution

/// Sum over the channels of (standard error)^2 / (a^2 + floor).
double relativeSquares(const PixelMoments& p, double floor) {
  const Vec3d variance = p.varianceOfMean();
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
    if (variance[c] > 0.0)
      sum += variance[c] / (p.mean[c] * p.mean[c] + floor);
  return sum;
}

} // namespace

FilmStatistics filmStatistics(const Film& film) {
  FilmStatistics s;
  Vec3d sum(0.0), variance(0.0);
  std::uint64_t measured = 0;
  bool errorKnown = true;
  for (const PixelMoments& p : film.pixels) {
    s.samples += p.count;
    if (!isFinite(p)) {
      ++s.nonFinitePixels;
      continue;
    }
    errorKnown = errorKnown && p.count >= 2;
    if (p.count == 0)
      continue;
    ++measured;
    sum += p.mean;
    variance += p.varianceOfMean();
  }
  if (measured == 0 || !errorKnown) {
    s.standardError = Vec3d(std::numeric_limits<double>::infinity());
    s.relativeError = std::numeric_limits<double>::infinity();
    s.relativeErrorUpper = s.relativeError;
  }
  if (measured == 0)
    return s;
  const auto n = static_cast<double>(measured);
  s.mean = sum / n;
  if (!errorKnown)
    return s;
  s.standardError = glm::sqrt(variance) / n;
  const double m = (s.mean.x + s.mean.y + s.mean.z) / 3.0;
  PixelMoments squares; // of the pixels' relative squared errors, in the first channel
  for (const PixelMoments& p : film.pixels)
    if (isMeasured(p))
      squares.merge({1, Vec3d(relativeSquares(p, (0.01 * m) * (0.01 * m)) / 3.0), Vec3d(0.0)});
  s.relativeError = std::sqrt(squares.mean.x);
  s.relativeErrorUpper = std::sqrt(squares.mean.x + kNormal95 * std::sqrt(squares.varianceOfMean().x));
  return s;
}

Image develop(const Film& film, const DevelopSettings& settings) {
  assert(film.width >= 0 && film.height >= 0);
  Image image(film.width, film.height, {"R", "G", "B"});
  if (settings.standardErrorLayer)
    for (const char* name : {"stderr.R", "stderr.G", "stderr.B"})
      image.addChannel(name);
  assert(film.pixels.size() == image.pixelCount());
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    const Vec3d standardError = glm::sqrt(film.pixels[i].varianceOfMean());
    for (int c = 0; c < 3; ++c) {
      const auto channel = static_cast<std::size_t>(c);
      image.channels[channel].values[i] = static_cast<float>(film.pixels[i].mean[c]);
      if (settings.standardErrorLayer)
        image.channels[channel + 3].values[i] = static_cast<float>(standardError[c]);
    }
  }
  return image;
}

} // namespace vkpt
