#include "film/film.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

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
  if (replicates >= 2)
    return between / (n * (replicates - 1.0)) + splatVariance;
  return m2 / (n * (n - 1.0)) + splatVariance;
}

namespace {

bool isFinite(const PixelMoments& p) { return vkpt::isFinite(p.mean) && vkpt::isFinite(p.m2); }
bool isMeasured(const PixelMoments& p) { return p.count > 0 && isFinite(p); }

constexpr double kNormal95 = 1.6448536269514722; // 95 % quantile of the normal distribution

constexpr double kWellKnown = 1.0 / 8.0; // a standard error below this share of the mean
/// From a pixel to those behind it whose crosses overlap its own.
constexpr std::array<std::pair<int, int>, 6> kOverlaps{{{1, 0}, {2, 0}, {-1, 1}, {0, 1}, {1, 1}, {0, 2}}};

/// The median over the pixel and its neighbours left, right, above and below, which keeps edges, corners and
/// lines. Where there is none, or none that is measured, the opposite one counts twice.
double crossMedian(const Film& film, int x, int y, int channel) {
  const double own = film.at(x, y).mean[channel];
  const auto valueAt = [&](int i, int j) -> std::optional<double> {
    const bool inside = i >= 0 && i < film.width && j >= 0 && j < film.height;
    return inside && isMeasured(film.at(i, j)) ? std::optional(film.at(i, j).mean[channel]) : std::nullopt;
  };
  const auto left = valueAt(x - 1, y), right = valueAt(x + 1, y), up = valueAt(x, y - 1),
             down = valueAt(x, y + 1);
  std::array<double, 5> values{own, left.value_or(right.value_or(own)), right.value_or(left.value_or(own)),
                               up.value_or(down.value_or(own)), down.value_or(up.value_or(own))};
  std::ranges::nth_element(values, values.begin() + 2);
  return values[2];
}

/// Mean over the channels of (standard error)^2 / (b^2 + floor). A pixel's own mean stands for b where it is
/// well known; else it goes up and down with its error: one that met a rare bright sample would count as
/// bright.
double relativeSquare(const Film& film, int x, int y, double floor) {
  const PixelMoments& p = film.at(x, y);
  const Vec3d variance = p.varianceOfMean();
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) {
    if (!(variance[c] > 0.0))
      continue;
    const double a = p.mean[c];
    const bool wellKnown = variance[c] < kWellKnown * kWellKnown * a * a;
    const double b = wellKnown ? a : crossMedian(film, x, y, c);
    sum += variance[c] / (b * b + floor);
  }
  return sum / 3.0;
}

/// Of every pixel; 0 where nothing is measured.
std::vector<double> relativeSquares(const Film& film, double floor) {
  std::vector<double> squares;
  squares.reserve(film.pixels.size());
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x < film.width; ++x)
      squares.push_back(isMeasured(film.at(x, y)) ? relativeSquare(film, x, y, floor) : 0.0);
  return squares;
}

/// Of the measured pixels' squares. Those of two pixels are correlated where their crosses overlap, up to two
/// steps away; a slow change over the image looks like that too, so this is rather too large.
double varianceOfSum(const Film& film, const std::vector<double>& squares, double mean) {
  const auto deviation = [&](int x, int y) {
    const bool inside = x >= 0 && x < film.width && y >= 0 && y < film.height;
    const auto i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) + static_cast<std::size_t>(x);
    return inside && isMeasured(film.pixels[i]) ? squares[i] - mean : 0.0;
  };
  double own = 0.0, overlapping = 0.0;
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x < film.width; ++x) {
      const double here = deviation(x, y);
      own += here * here;
      for (const auto& [dx, dy] : kOverlaps) // each pair once
        overlapping += 2.0 * here * deviation(x + dx, y + dy);
    }
  return own + std::max(overlapping, 0.0);
}

} // namespace

FilmStatistics filmStatistics(const Film& film) {
  FilmStatistics s;
  Vec3d sum(0.0), variance(0.0), splats(0.0);
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
    splats += p.splatVariance;
  }
  if (film.splatVarianceOfMean) {
    const auto n = static_cast<double>(measured);
    variance += *film.splatVarianceOfMean * (n * n) - splats;
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
  const std::vector<double> squares = relativeSquares(film, (0.01 * m) * (0.01 * m));
  const double mean = std::accumulate(squares.begin(), squares.end(), 0.0) / n;
  s.relativeError = std::sqrt(mean);
  s.relativeErrorUpper = std::sqrt(mean + kNormal95 * std::sqrt(varianceOfSum(film, squares, mean)) / n);
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
