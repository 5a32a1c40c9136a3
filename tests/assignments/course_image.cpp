#include "assignments/course_image.h"

namespace vkpt::test {

const TileMeans& courseTiles() {
  static const TileMeans tiles{{
#include "assignments/course_tiles.inl"
  }};
  return tiles;
}

TileMeans tileMeans(const Image& image) {
  TileMeans tiles{};
  const int w = image.width / kTilesAlong;
  const int h = image.height / kTilesAlong;
  for (int y = 0; y < h * kTilesAlong; ++y) {
    for (int x = 0; x < w * kTilesAlong; ++x) {
      const auto pixel = static_cast<std::size_t>(y * image.width + x);
      for (int c = 0; c < 3; ++c) {
        tiles[static_cast<std::size_t>(y / h)][static_cast<std::size_t>(x / w)][c] +=
            static_cast<double>(image.channels[static_cast<std::size_t>(c)].values[pixel]) / (w * h);
      }
    }
  }
  return tiles;
}

TileEstimate tileEstimate(const Film& film, int row, int column) {
  const int w = film.width / kTilesAlong;
  const int h = film.height / kTilesAlong;
  const double pixels = static_cast<double>(w) * h;
  TileEstimate tile{Vec3d(0.0), Vec3d(0.0)};
  for (int y = row * h; y < (row + 1) * h; ++y) {
    for (int x = column * w; x < (column + 1) * w; ++x) {
      tile.mean += film.at(x, y).mean / pixels;
      tile.variance += film.at(x, y).varianceOfMean() / (pixels * pixels);
    }
  }
  return tile;
}

} // namespace vkpt::test
