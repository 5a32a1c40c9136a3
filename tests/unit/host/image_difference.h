#pragma once
// How far two renders of the same paths are apart.

#include "film/film.h"

namespace vkpt::test {

struct ImageDifference {
  int pixels = 0;        ///< that differ by more than 1e-3 of the larger value in some channel
  double meanOverSe = 0; ///< difference of the images' means over a's standard error, largest of the channels
};
ImageDifference differenceOf(const Film& a, const Film& b);

/// Paths part where rounding decides a comparison (the light's edge, a shadow's, roulette, Fresnel), which
/// happens to few samples, independently of each other: a Poisson number of them, `perSample` for each
/// sample.
struct PartedPaths {
  int most;          ///< exceeded with probability 1e-6
  double meanOverSe; ///< so many samples replaced by independent ones move the mean by sqrt(2 most / samples)
                     ///< SE; 4.5 times that
};
PartedPaths partedPaths(double perSample, double samples);

} // namespace vkpt::test
