#pragma once
// A picture with numbered arrows in it, as a file of its own.

#include "core/error.h"

#include <span>
#include <string>
#include <string_view>

namespace vkpt {

/// Places as shares of width and height, from the top left.
struct Annotation {
  double spotX, spotY;   ///< that the arrow points to
  double labelX, labelY; ///< where its number and label begin
  std::string_view label;
};

/// SVG with the PNG in it; the annotations are numbered from 1.
std::string annotatedSvg(const fs::path& png, int width, int height, std::span<const Annotation> annotations);

} // namespace vkpt
