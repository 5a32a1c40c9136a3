#include "selftest/statistics.h"

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace vkpt::selftest {
namespace {

constexpr int kTileEdge = 8;

Estimate estimateOfTile(const Film& film, int x0, int y0, int x1, int y1) {
  Estimate e;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      e.mean += film.at(x, y).mean;
      e.variance += film.at(x, y).varianceOfMean();
    }
  }
  const double n = static_cast<double>(x1 - x0) * static_cast<double>(y1 - y0);
  e.mean /= n;
  e.variance /= n * n;
  return e;
}

bool sameBits(const Vec3d& a, const Vec3d& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

} // namespace

double sidakBound(std::size_t tests, double alpha) {
  const double each = -std::expm1(std::log1p(-alpha) / static_cast<double>(tests));
  return boost::math::quantile(boost::math::complement(boost::math::normal(), 0.5 * each));
}

Estimate estimateOf(const Film& film) { return estimateOfTile(film, 0, 0, film.width, film.height); }

std::vector<Estimate> tileEstimates(const Film& film) {
  std::vector<Estimate> tiles;
  for (int y = 0; y < film.height; y += kTileEdge) {
    for (int x = 0; x < film.width; x += kTileEdge) {
      tiles.push_back(estimateOfTile(film, x, y, std::min(x + kTileEdge, film.width),
                                     std::min(y + kTileEdge, film.height)));
    }
  }
  return tiles;
}

Vec3d welch(const Estimate& a, const Estimate& b) {
  Vec3d z(0.0);
  for (int c = 0; c < 3; ++c) {
    const double difference = a.mean[c] - b.mean[c];
    const double variance = a.variance[c] + b.variance[c];
    if (difference != 0.0)
      z[c] = variance > 0.0 ? difference / std::sqrt(variance) : std::numeric_limits<double>::infinity();
  }
  return z;
}

double maxAbs(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double correlation(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size());
  const auto n = static_cast<double>(a.size());
  double meanA = 0.0;
  double meanB = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    meanA += a[i] / n;
    meanB += b[i] / n;
  }
  double aa = 0.0;
  double bb = 0.0;
  double ab = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - meanA) * (a[i] - meanA);
    bb += (b[i] - meanB) * (b[i] - meanB);
    ab += (a[i] - meanA) * (b[i] - meanB);
  }
  return ab / std::sqrt(aa * bb);
}

bool identical(const Film& a, const Film& b) {
  return a.width == b.width && a.height == b.height &&
         std::ranges::equal(a.pixels, b.pixels, [](const PixelMoments& p, const PixelMoments& q) {
           return p.count == q.count && sameBits(p.mean, q.mean) && sameBits(p.m2, q.m2);
         });
}

} // namespace vkpt::selftest
