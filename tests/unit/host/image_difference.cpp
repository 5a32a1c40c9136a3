#include "unit/host/image_difference.h"

#include <algorithm>
#include <cmath>

namespace vkpt::test {

ImageDifference differenceOf(const Film& a, const Film& b) {
  ImageDifference d;
  double squares = 0.0;
  int close = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double x = a.pixels[i].mean[c];
      const double y = b.pixels[i].mean[c];
      if (x != y)
        worst = std::max(worst, std::abs(x - y) / std::max(std::abs(x), std::abs(y)));
    }
    if (!(worst <= 1e-3)) {
      ++d.pixels;
    } else {
      squares += worst * worst;
      ++close;
    }
  }
  d.rms = std::sqrt(squares / std::max(close, 1));
  const FilmStatistics sa = filmStatistics(a);
  const FilmStatistics sb = filmStatistics(b);
  for (int c = 0; c < 3; ++c)
    d.meanOverSe = std::max(d.meanOverSe, std::abs(sa.mean[c] - sb.mean[c]) / sa.standardError[c]);
  return d;
}

} // namespace vkpt::test
