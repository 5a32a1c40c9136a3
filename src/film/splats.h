#pragma once
// What paths from the lights bring to the film, as integers: no order of adding changes the sums.

#include "film/film.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vkpt {

/// Units that a sum counts: so many for a radiance of 1, and of its squares for a squared radiance of 1.
struct SplatScale {
  float units = 1.0F;
  float squareUnits = 1.0F;
};

/// In the order of shared::kSplatNumbers and kSplatParts, two numbers of the device to one of 64 bits: by
/// pixel and channel sum and sum of squares, then by part and channel the sum.
class SplatSums {
public:
  SplatSums() = default; ///< of a film without splats
  SplatSums(int width, int height);
  explicit SplatSums(std::vector<std::uint64_t> numbers) : m_numbers(std::move(numbers)) {}
  [[nodiscard]] bool empty() const { return m_numbers.empty(); }
  [[nodiscard]] std::span<std::uint64_t> numbers() { return m_numbers; }
  /// From any thread.
  void add(std::size_t number, std::uint64_t value);
  /// Of a pixel whose film has `paths` for each pixel of the image: adds the splats' mean and variance.
  void addTo(PixelMoments& moments, std::size_t pixel, const SplatScale& scale, double frames,
             double paths) const;
  /// To every pixel, and the variance of the film's mean. Samples and paths from lights are equally many.
  void addTo(Film& film, const SplatScale& scale) const;

private:
  std::vector<std::uint64_t> m_numbers;
};

/// How many numbers of 64 bits there are.
std::size_t splatNumbers(int width, int height);

} // namespace vkpt
