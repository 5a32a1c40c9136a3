#pragma once
// Reconstruction filters as shaders/lib/filter.glsl samples them.

#include "scene/scene.h"
#include "shared/structs.h"

namespace vkpt {

/// Uniform over the pixel: what a jittered sample is without any filter.
bool isPixelBox(const PixelFilter& filter);

/// Fills the filter's part of `constants`: its shape, scaled to an integral of 1, and the edges of the bins
/// of equal probability. Throws UsageError for a radius or a stddev that is not above 0.
void setFilter(shared::FrameConstants& constants, const PixelFilter& filter);

} // namespace vkpt
