#include "film/compare.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace vkpt {
namespace {

constexpr double kFloorShare = 0.01; // of the reference's mean: what keeps dark pixels from deciding relMSE

Vec3d colourAt(const Image& image, std::size_t pixel) {
  return {image.channels[0].values[pixel], image.channels[1].values[pixel], image.channels[2].values[pixel]};
}

bool bothFinite(const Image& a, const Image& b, std::size_t pixel) {
  return isFinite(colourAt(a, pixel)) && isFinite(colourAt(b, pixel));
}

/// (0.01 m)^2, m the mean of the reference over the pixels that are compared.
double relativeFloor(const Image& image, const Image& reference) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    if (!bothFinite(image, reference, i))
      continue;
    const Vec3d b = colourAt(reference, i);
    sum += b.x + b.y + b.z;
    count += 3.0;
  }
  const double floor = count > 0.0 ? kFloorShare * sum / count : 0.0;
  return floor * floor;
}

/// Sum over the channels of (a - b)^2 / (b^2 + floor).
double relativeSquares(const Vec3d& a, const Vec3d& b, double floor) {
  double sum = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double square = (a[c] - b[c]) * (a[c] - b[c]);
    if (square > 0.0)
      sum += square / (b[c] * b[c] + floor);
  }
  return sum;
}

std::array<const Image::Channel*, 3> errorLayers(const Image& image) {
  return {image.find("stderr.R"), image.find("stderr.G"), image.find("stderr.B")};
}

/// Sum over the compared pixels of the squared standard errors.
std::optional<Vec3d> sumOfVariances(const Image& carrier, const Image& image, const Image& reference) {
  const auto layers = errorLayers(carrier);
  if (std::ranges::find(layers, nullptr) != layers.end())
    return std::nullopt;
  Vec3d sum(0.0);
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    if (!bothFinite(image, reference, i))
      continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = layers[c]->values[i];
      sum[static_cast<int>(c)] += error * error;
    }
  }
  return sum;
}

std::optional<Vec3d> zOf(const Image& image, const Image& reference, const ImageDifference& d) {
  const std::optional<Vec3d> own = sumOfVariances(image, image, reference);
  if (!own)
    return std::nullopt;
  const Vec3d variance = *own + sumOfVariances(reference, image, reference).value_or(Vec3d(0.0));
  if (!(variance.x > 0.0 && variance.y > 0.0 && variance.z > 0.0))
    return std::nullopt;
  return d.meanDifference * static_cast<double>(d.pixels) / glm::sqrt(variance);
}

} // namespace

std::optional<double> ImageDifference::z() const {
  if (!zByChannel)
    return std::nullopt;
  double farthest = 0.0;
  for (int c = 0; c < 3; ++c) {
    if (std::abs((*zByChannel)[c]) >= std::abs(farthest))
      farthest = (*zByChannel)[c];
  }
  return farthest;
}

ImageDifference compareImages(const Image& image, const Image& reference) {
  assert(image.width == reference.width && image.height == reference.height);
  const double floor = relativeFloor(image, reference);
  ImageDifference d;
  Vec3d squares(0.0);
  double peak = 0.0;
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    if (!bothFinite(image, reference, i)) {
      ++d.nonFinite;
      continue;
    }
    ++d.pixels;
    const Vec3d a = colourAt(image, i), b = colourAt(reference, i);
    squares += (a - b) * (a - b);
    d.meanDifference += a - b;
    d.relMse += relativeSquares(a, b, floor);
    peak = std::max({peak, b.x, b.y, b.z});
  }
  if (d.pixels == 0)
    return d;
  const auto n = static_cast<double>(d.pixels);
  d.mse = (squares.x + squares.y + squares.z) / (3.0 * n);
  d.rmse = std::sqrt(d.mse);
  d.relMse /= 3.0 * n;
  d.meanDifference /= n;
  d.psnr = d.mse > 0.0 ? 10.0 * std::log10(peak * peak / d.mse) : std::numeric_limits<double>::infinity();
  d.zByChannel = zOf(image, reference, d);
  return d;
}

Vec3d magma(double t) {
  static const std::array<Vec3d, 7> kCoefficients{{
      {-0.002136485053939582, -0.000749655052795221, -0.005386127855323933},
      {0.2516605407371642, 0.6775232436837668, 2.494026599312351},
      {8.353717279216625, -3.577719514958484, 0.3144679030132573},
      {-27.66873308576866, 14.26473078096533, -13.64921318813922},
      {52.17613981234068, -27.94360607168351, 12.94416944238394},
      {-50.76852536473588, 29.04658282127291, 4.23415299384598},
      {18.65570506591883, -11.48977351997711, -5.601961508734096},
  }};
  const double x = std::clamp(t, 0.0, 1.0);
  Vec3d colour(0.0);
  for (auto c = kCoefficients.rbegin(); c != kCoefficients.rend(); ++c)
    colour = colour * x + *c;
  return glm::clamp(colour, Vec3d(0.0), Vec3d(1.0));
}

Image differencePicture(const Image& image, const Image& reference) {
  constexpr double kDecades = 3.0; // 0.1 % to 100 %
  const double floor = relativeFloor(image, reference);
  Image picture(image.width, image.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    Vec3d colour(0.0, 1.0, 0.0);
    if (bothFinite(image, reference, i)) {
      const double error =
          std::sqrt(relativeSquares(colourAt(image, i), colourAt(reference, i), floor) / 3.0);
      colour = magma(error > 0.0 ? 1.0 + std::log10(error) / kDecades : 0.0);
    }
    for (std::size_t c = 0; c < 3; ++c)
      picture.channels[c].values[i] = static_cast<float>(colour[static_cast<int>(c)]);
  }
  return picture;
}

} // namespace vkpt
