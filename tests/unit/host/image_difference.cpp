#include "unit/host/image_difference.h"

#include <algorithm>
#include <cmath>

namespace vkpt::test {

ImageDifference differenceOf(const Film& a, const Film& b) {
  ImageDifference d;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double x = a.pixels[i].mean[c];
      const double y = b.pixels[i].mean[c];
      if (x != y)
        worst = std::max(worst, std::abs(x - y) / std::max(std::abs(x), std::abs(y)));
    }
    d.pixels += worst <= 1e-3 ? 0 : 1;
  }
  const FilmStatistics sa = filmStatistics(a);
  const FilmStatistics sb = filmStatistics(b);
  for (int c = 0; c < 3; ++c)
    d.meanOverSe = std::max(d.meanOverSe, std::abs(sa.mean[c] - sb.mean[c]) / sa.standardError[c]);
  return d;
}

PartedPaths partedPaths(double perSample, double samples) {
  const double expected = perSample * samples;
  double probability = std::exp(-expected);
  double more = 1.0 - probability;
  int most = 0;
  while (more > 1e-6) {
    ++most;
    probability *= expected / most;
    more -= probability;
  }
  return {most, 4.5 * std::sqrt(2.0 * most / samples)};
}

} // namespace vkpt::test
