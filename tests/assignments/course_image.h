#pragma once
// The course's own image of assignment B's Cornell box, as figures: means over an 8 x 8 grid of tiles.

#include "film/film.h"
#include "film/image.h"

#include <array>

namespace vkpt::test {

inline constexpr int kTilesAlong = 8;
using TileMeans = std::array<std::array<Vec3d, kTilesAlong>, kTilesAlong>; ///< [row from the top][column]

/// Of cbox-ref.exr, 512 x 512, by its authors rendered with an unlimited number of bounces.
const TileMeans& courseTiles();

TileMeans tileMeans(const Image& image);

struct TileEstimate {
  Vec3d mean;
  Vec3d variance; ///< of the mean
};
TileEstimate tileEstimate(const Film& film, int row, int column);

} // namespace vkpt::test
