#pragma once
// How far an image is from a reference.

#include "core/math.h"
#include "film/image.h"

#include <cstdint>
#include <optional>

namespace vkpt {

/// Of linear values (PNG files are decoded), over the pixels that are finite in both images.
struct ImageDifference {
  double mse = 0.0;    ///< mean of (a - b)^2 over pixels and channels, a the image, b the reference
  double rmse = 0.0;   ///< its square root
  double relMse = 0.0; ///< mean of (a - b)^2 / (b^2 + (0.01 m)^2), m the mean of b; a term 0 / 0 is 0
  double psnr =
      0.0; ///< dB, 10 log10(peak^2 / mse), the peak the reference's largest value; infinite at mse 0
  Vec3d meanDifference{0.0}; ///< mean of a - b
  /// The mean difference over its standard error: of a standard normal distribution where both images have
  /// the same expectation. Nothing unless the image tells its errors (layer stderr.{R,G,B}) and they are
  /// above 0; a reference that tells none counts as exact.
  std::optional<Vec3d> zByChannel;
  std::uint64_t pixels = 0;    ///< that were compared
  std::uint64_t nonFinite = 0; ///< left out: not finite in one image or in both

  /// Of the channels' z the one farthest from 0. The channels share their paths, so their z do not add up.
  [[nodiscard]] std::optional<double> z() const;
};

/// Both images are of one size and have R, G and B.
ImageDifference compareImages(const Image& image, const Image& reference);

/// The share of each pixel in sqrt(relMSE), the root of its mean over the channels, as a colour of magma:
/// from 0.1 % (black) to 100 % (pale yellow), logarithmic; green where a value is not finite. Display values,
/// to be written with Tonemap::None.
Image differencePicture(const Image& image, const Image& reference);

/// The colour map magma (S. van der Walt, N. Smith 2015, matplotlib) for t in [0, 1], clamped: sRGB display
/// values by M. Zucker's polynomial (shadertoy.com/view/WlfXRN), which is within 0.02 of the table.
Vec3d magma(double t);

} // namespace vkpt
