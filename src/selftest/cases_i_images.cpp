// Images and cameras at their limits.
#include "selftest/case.h"
#include "selftest/scene_builder.h"
#include "selftest/statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::selftest {
namespace {

/// Every pixel of images of odd shapes has its samples, and the furnace's value.
void shapesOfImages(Trial& t) {
  const EstimatorSettings settings = withBounces(withoutRoulette(bsdfSampling()), 1);
  const std::pair<int, int> sizes[] = {{1, 1}, {16384, 1}, {1, 16384}, {7, 65}};
  for (const auto& [width, height] : sizes) {
    const Film film =
        t.render(furnace(Vec3f(0.5F)), {.estimator = settings, .width = width, .height = height, .frames = 3})
            .film;
    t.expectConstant(film, Vec3d(1.5), 0, fmt::format("{}x{}", width, height));
  }
}

/// What a field of view spans, of a plane before the eye: from a thousandth of a millionth of a degree to
/// nearly half a turn.
void fieldsOfView(Trial& t) {
  for (const double degrees : {1e-6, 1e-2, 90.0, 179.9}) {
    // A lamp of half the width that is seen, at the distance 1.
    const double half = std::tan(degrees * std::numbers::pi / 360.0);
    SceneBuilder builder;
    builder.quad({-0.5 * half, -half, -1.0}, {0.5 * half, -half, -1.0}, {0.5 * half, half, -1.0},
                 {-0.5 * half, half, -1.0}, emitter(Vec3f(1.0F)));
    builder.camera(lookAt(Vec3d(0.0), {0.0, 0.0, -1.0}, degrees));
    const Film film = t.render(builder.build(), {.width = 32, .height = 16, .frames = 16}).film;
    const std::string name = fmt::format("{:g} degrees", degrees);
    for (int x = 0; x < film.width; ++x) {
      if (x != 7 && x != 8 && x != 23 && x != 24) // the borders, which rounding may move
        t.expect(film.at(x, 8).mean.x == (x > 8 && x < 23 ? 1.0 : 0.0),
                 fmt::format("{}: column {}", name, x));
    }
  }
}

constexpr Case kImageCases[] = {
    {"i1-shapes-of-images", "of images of 1x1 to 16384x1 every pixel has its samples", shapesOfImages},
    {"i2-fields-of-view", "fields of view of 1e-6 and of 179.9 degrees span what they should", fieldsOfView},
};

} // namespace

std::span<const Case> imageCases() { return kImageCases; }

} // namespace vkpt::selftest
