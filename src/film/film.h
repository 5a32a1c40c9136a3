#pragma once
// The film: what has been measured at each pixel. Linear, scene-referred; no Vulkan here.

#include "core/math.h"
#include "film/image.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace vkpt {

/// Running moments of one pixel's radiance (W m^-2 sr^-1). `m2` is the sum of squared deviations from the
/// mean, per channel. One sample x is {1, x, 0}.
struct PixelMoments {
  std::uint64_t count = 0; ///< samples
  Vec3d mean{0.0};
  Vec3d m2{0.0};
  /// Point sets, scrambled independently, that the samples belong to; below 2 the samples are taken as
  /// independent.
  std::uint32_t replicates = 0;
  Vec3d between{0.0}; ///< sum over the replicates of samples times squared deviation of the mean
  /// Of the mean of what paths from the lights bring, which is part of `mean` and independent of the samples.
  Vec3d splatVariance{0.0};

  /// Adds another set of samples: Chan, Golub, LeVeque 1979, "Updating formulae and a pairwise algorithm".
  /// Equal means leave mean and m2 as they are to the last bit; m2 never becomes negative; a set without
  /// samples changes nothing. The replicates are those of `this`.
  void merge(const PixelMoments& other);
  /// Variance of the mean (squared standard error) per channel: m2 / (n (n - 1)), or
  /// between / (n (replicates - 1)) where there are two replicates, and splatVariance; 0 while count < 2,
  /// where it is not known.
  [[nodiscard]] Vec3d varianceOfMean() const;
};

/// Row 0 is the top row.
struct Film {
  int width = 0;
  int height = 0;
  std::vector<PixelMoments> pixels; ///< width * height
  /// Of the film's mean, where paths from the lights bring something: they bring it to several pixels each.
  std::optional<Vec3d> splatVarianceOfMean{};
  [[nodiscard]] const PixelMoments& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Figures of the whole image. Left out of all but the counts are pixels whose mean or m2 is not finite, and
/// pixels without a sample.
struct FilmStatistics {
  Vec3d mean{0.0};            ///< mean linear radiance, W m^-2 sr^-1
  Vec3d standardError{0.0};   ///< of that mean; infinite where not known, see filmStatistics()
  double relativeError = 0.0; ///< estimate of sqrt(relMSE); infinite where not known, see filmStatistics()
  /// Upper 95 % confidence bound of relativeError: the pixels' squared errors are estimates themselves, and
  /// their mean has a standard error. Equal to relativeError for a single pixel, whose scatter is not known.
  double relativeErrorUpper = 0.0;
  std::uint64_t nonFinitePixels = 0;
  std::uint64_t samples = 0; ///< over all pixels
};

/// relMSE = mean over pixels and channels of (a - b)^2 / (b^2 + (0.01 m)^2), m the mean of b over pixels and
/// channels; here (a - b)^2 is estimated by the squared standard error, and b by a where its standard error
/// is below an eighth of it, else by the median of it and its four neighbours. A term 0 / 0 is 0. The
/// standard error of the image's mean is sqrt(sum of varianceOfMean) / pixels: pixels are taken as
/// independent but for their splats. One sample tells nothing of its error, so while any finite pixel has
/// fewer than two, both errors are infinite: no rule that stops at an error can stop on them.
FilmStatistics filmStatistics(const Film& film);

struct DevelopSettings {
  bool standardErrorLayer = true; ///< adds `stderr.R`, `stderr.G`, `stderr.B`
};

/// The film as an image: channels R, G, B (the means) and, if asked for, stderr.{R,G,B} (the standard errors
/// of these, 0 while a pixel has fewer than two samples); linear, unclamped, rounded to float.
Image develop(const Film& film, const DevelopSettings& settings = {});

} // namespace vkpt
