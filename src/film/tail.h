#pragma once
// How heavy the tail of the samples is: whether a standard error means what it says.

#include "film/film.h"

#include <optional>

namespace vkpt {

/// P(|sample| > x) falls as x^-index. Below 2 the variance is infinite, and standard errors are too small
/// however many samples there are.
struct TailEstimate {
  double index = 0.0;
  double standardError = 0.0;
  /// 95 % sure that the variance is infinite, or that too few of the rare bright samples were met to tell.
  [[nodiscard]] bool heavy() const { return index + 1.645 * standardError < 2.0; }
};

/// Hill's estimate (Hill 1975, Annals of Statistics 3(5)) from the pixels' sample variances, whose tail index
/// is half that of the samples. Each is taken relative to the second largest among its eight neighbours: an
/// edge, which runs through a neighbour or two, does not look like a tail. Nothing for an image too small to
/// tell, or while a pixel has fewer than two samples.
std::optional<TailEstimate> estimateTail(const Film& film);

} // namespace vkpt
