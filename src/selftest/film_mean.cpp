#include "selftest/film_mean.h"

#include "selftest/luminance.h"
#include "shared/structs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace vkpt {

MeanEstimate meanLuminance(const Film& film) {
  MeanEstimate estimate;
  double variances = 0.0;
  double squares = 0.0; // of the variances, over their degrees of freedom
  double samples = 0.0;
  for (const PixelMoments& pixel : film.pixels) {
    assert(pixel.count >= 2);
    const double error = luminanceOf(glm::sqrt(pixel.varianceOfMean()));
    const double variance = error * error;
    estimate.mean += luminanceOf(pixel.mean);
    variances += variance;
    squares += variance * variance / static_cast<double>(pixel.count - 1);
    samples += static_cast<double>(pixel.count);
  }
  const auto pixels = static_cast<double>(film.pixels.size());
  estimate.mean /= pixels;
  estimate.variance = std::max(variances / (pixels * pixels), kLeastSampleVariance / samples);
  estimate.degrees = squares > 0.0 ? variances * variances / squares : samples - pixels;
  return estimate;
}

std::pair<int, int> sizeForSamples(int width, int height, int samples) {
  const int divisor = std::gcd(width, height);
  const int shapeX = width / divisor;
  const int shapeY = height / divisor;
  const double pixels = static_cast<double>(samples) / shared::kSamplesPerGroup;
  const int factor =
      std::max(1, static_cast<int>(std::sqrt(pixels / (static_cast<double>(shapeX) * shapeY))));
  return {shapeX * factor, shapeY * factor};
}

} // namespace vkpt
