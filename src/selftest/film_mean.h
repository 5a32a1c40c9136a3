#pragma once
// The mean luminance of a rendered image, and how well it is known.

#include "film/film.h"
#include "selftest/hypothesis.h"

#include <utility>

namespace vkpt {

/// The mean over all pixels, which are strata of equal weight. Its variance comes from the pixels' own: what
/// lies between pixels is not counted. The channels' correlation is not known and taken as 1, which makes the
/// variance an upper bound, exact for grey light. Degrees of freedom: Welch 1947, Satterthwaite 1946. Every
/// pixel needs two samples.
MeanEstimate meanLuminance(const Film& film);

/// Width and height of the same shape with 16 or more of `samples` for a pixel, where the shape allows it.
std::pair<int, int> sizeForSamples(int width, int height, int samples);

} // namespace vkpt
