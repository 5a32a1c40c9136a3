// Assignment B's Cornell box against the course's own image.
#include "assignments/course_image.h"
#include "scenes/render_fixture.h"

#include "film/image.h"
#include "scene/load.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <fmt/format.h>

#include <iostream>

namespace vkpt::test {
namespace {

const fs::path kCourse = fs::path(VKPT_SOURCE_DIR) / "../shared/data/assignment-b";

class CourseImage : public RenderTest {
protected:
  /// Tile by tile and as a whole. The tiles' squared z-scores add up to chi-square where only chance is at
  /// work; the course's image has noise of its own.
  void compare(const fs::path& file, std::uint64_t frames) {
    SceneReport report;
    const Scene scene = loadScene(std::array{file}, report);
    RenderSetup setup{.width = scene.width, .height = scene.height, .frames = frames};
    const Film film = render(scene, setup).film;
    // The course's image has the noise of about this many of our frames: against 768 of them, whose own noise
    // alone would give the tiles' z-scores an sd of 1, it was 1.12.
    const double share = 1.0 + static_cast<double>(frames) / kCourseFrames;
    Vec3d squares(0.0), difference(0.0), variance(0.0), mean(0.0);
    for (int row = 0; row < kTilesAlong; ++row) {
      for (int column = 0; column < kTilesAlong; ++column) {
        const TileEstimate tile = tileEstimate(film, row, column);
        const Vec3d d =
            tile.mean - courseTiles()[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
        squares += d * d / (tile.variance * share);
        difference += d;
        mean += tile.mean;
        variance += tile.variance * share;
      }
    }
    const boost::math::chi_squared chance(kTilesAlong * kTilesAlong);
    for (int c = 0; c < 3; ++c) {
      const double z = difference[c] / std::sqrt(variance[c]);
      std::cout << fmt::format("channel {}: z of the whole mean {:.2f}, sd of the tiles' z {:.2f}\n", c, z,
                               std::sqrt(squares[c] / (kTilesAlong * kTilesAlong)));
      EXPECT_LT(std::abs(z), 4.0);
      EXPECT_LT(squares[c], quantile(complement(chance, 1e-5)));
      EXPECT_GT(squares[c], quantile(chance, 1e-5));
      EXPECT_LT(std::sqrt(variance[c]), 0.0015 * mean[c]) << "too noisy to show a bias of half a per cent";
    }
  }
  static constexpr double kCourseFrames = 3000.0;
};

TEST_F(CourseImage, IsOurCornellBox) { compare(fs::path(VKPT_SOURCE_DIR) / "assets/cbox.xml", 32); }

TEST_F(CourseImage, IsTheAssignmentsOwnFile) {
  if (!fs::exists(kCourse))
    GTEST_SKIP() << kCourse << " is not here";
  compare(kCourse / "cbox-path.xml", 32);
}

TEST_F(CourseImage, FiguresAreThoseOfTheFile) {
  if (!fs::exists(kCourse))
    GTEST_SKIP() << kCourse << " is not here";
  const TileMeans tiles = tileMeans(readImage(kCourse / "cbox-ref.exr"));
  for (std::size_t row = 0; row < kTilesAlong; ++row) {
    for (std::size_t column = 0; column < kTilesAlong; ++column) {
      const Vec3d& t = tiles[row][column];
      const Vec3d& committed = courseTiles()[row][column];
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(t[c], committed[c], 1e-6 + 1e-5 * t[c])
            << fmt::format("{{{:.7g}, {:.7g}, {:.7g}}}", t.x, t.y, t.z);
    }
  }
}

} // namespace
} // namespace vkpt::test
