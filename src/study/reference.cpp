#include "study/reference.h"

#include <array>
#include <cassert>
#include <cmath>

namespace vkpt {
namespace {

/// Adds squares (of a difference, or a variance) at a pixel whose reference is b.
void add(SquaredError& sum, const Vec3d& squares, const Vec3d& b, double floor) {
  for (int c = 0; c < 3; ++c) {
    sum.mse += squares[c];
    if (squares[c] > 0.0)
      sum.relMse += squares[c] / (b[c] * b[c] + floor);
  }
}

SquaredError dividedBy(double values, const SquaredError& sum) {
  return values > 0.0 ? SquaredError{sum.mse / values, sum.relMse / values} : SquaredError{};
}

std::array<const Image::Channel*, 3> errorLayers(const Image& image) {
  return {image.find("stderr.R"), image.find("stderr.G"), image.find("stderr.B")};
}

} // namespace

Reference::Reference(const Film& film) : m_width(film.width), m_height(film.height) {
  for (const PixelMoments& p : film.pixels) {
    m_mean.push_back(p.mean);
    m_variance.push_back(p.varianceOfMean());
  }
  summarise();
}

Reference::Reference(const Image& image) : m_width(image.width), m_height(image.height) {
  const auto errors = errorLayers(image);
  m_noiseIsKnown = errors[0] != nullptr && errors[1] != nullptr && errors[2] != nullptr;
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    Vec3d mean(0.0), error(0.0);
    for (std::size_t c = 0; c < 3; ++c) {
      mean[static_cast<int>(c)] = image.channels[c].values[i];
      if (m_noiseIsKnown)
        error[static_cast<int>(c)] = errors[c]->values[i];
    }
    m_mean.push_back(mean);
    m_variance.push_back(error * error);
  }
  summarise();
}

void Reference::summarise() {
  Vec3d sum(0.0), variance(0.0);
  double pixels = 0.0;
  for (std::size_t i = 0; i < m_mean.size(); ++i) {
    if (!isFinite(m_mean[i]))
      continue;
    sum += m_mean[i];
    variance += m_variance[i];
    pixels += 1.0;
  }
  if (pixels == 0.0)
    return;
  m_imageMean = sum / pixels;
  m_imageError = glm::sqrt(variance) / pixels;
  const double m = (m_imageMean.x + m_imageMean.y + m_imageMean.z) / 3.0;
  m_floor = (0.01 * m) * (0.01 * m);
  m_noise = over([this](std::size_t i) { return m_variance[i]; });
}

template<class Function>
SquaredError Reference::over(Function&& squaresAt) const {
  SquaredError sum;
  double pixels = 0.0;
  for (std::size_t i = 0; i < m_mean.size(); ++i) {
    const Vec3d squares = squaresAt(i);
    if (!isFinite(squares) || !isFinite(m_mean[i]))
      continue;
    add(sum, squares, m_mean[i], m_floor);
    pixels += 1.0;
  }
  return dividedBy(3.0 * pixels, sum);
}

SquaredError Reference::measure(const Film& film) const {
  assert(film.pixels.size() == m_mean.size());
  return over([&](std::size_t i) {
    const Vec3d difference = film.pixels[i].mean - m_mean[i];
    return difference * difference;
  });
}

SquaredError Reference::predict(const Film& film) const {
  assert(film.pixels.size() == m_mean.size());
  return over([&](std::size_t i) { return film.pixels[i].varianceOfMean(); });
}

Image Reference::image() const {
  Image image(m_width, m_height, {"R", "G", "B"});
  for (std::size_t i = 0; i < m_mean.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      image.channels[c].values[i] = static_cast<float>(m_mean[i][static_cast<int>(c)]);
  return image;
}

} // namespace vkpt
