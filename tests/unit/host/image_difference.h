#pragma once
// How far two renders of the same paths are apart.

#include "film/film.h"

namespace vkpt::test {

struct ImageDifference {
  int pixels = 0;        ///< that differ by more than 1e-3 of the larger value in some channel
  double meanOverSe = 0; ///< difference of the images' means over a's standard error, largest of the channels
  double rms = 0;        ///< relative, over the pixels that don't differ so
};
ImageDifference differenceOf(const Film& a, const Film& b);

} // namespace vkpt::test
