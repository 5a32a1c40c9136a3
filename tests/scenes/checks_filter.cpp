// Reconstruction filters: the image of a straight edge is the filter's running integral.
#include "scenes/scene_extras.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::test {
namespace {

struct NamedFilter {
  const char* name;
  PixelFilter filter;
};
const NamedFilter kFilters[] = {
    {"wide box", {PixelFilter::Shape::Box, 1.25, 0.5, 0.0, 0.0}},
    {"tent", {PixelFilter::Shape::Tent, 1.0, 0.5, 0.0, 0.0}},
    {"gaussian", {PixelFilter::Shape::Gaussian, 2.0, 0.5, 0.0, 0.0}},
    {"mitchell", {PixelFilter::Shape::Mitchell, 2.0, 0.5, 1.0 / 3.0, 1.0 / 3.0}},
    {"mitchell of radius 2.5", {PixelFilter::Shape::Mitchell, 2.5, 0.5, 0.0, 0.5}},
};

/// The filter's shape, of any scale. Mitchell and Netravali 1988, for samples a distance of radius / 2 apart.
double shapeOf(const PixelFilter& f, double x) {
  const double r = std::abs(x);
  if (r >= f.radius)
    return 0.0;
  switch (f.shape) {
  case PixelFilter::Shape::Box:
    return 1.0;
  case PixelFilter::Shape::Tent:
    return 1.0 - r / f.radius;
  case PixelFilter::Shape::Gaussian: {
    const auto bell = [&](double d) { return std::exp(-d * d / (2.0 * f.stddev * f.stddev)); };
    return bell(r) - bell(f.radius);
  }
  case PixelFilter::Shape::Mitchell: {
    const double d = 2.0 * r / f.radius;
    const double d2 = d * d;
    const double d3 = d2 * d;
    return d < 1.0 ? (12 - 9 * f.b - 6 * f.c) * d3 + (-18 + 12 * f.b + 6 * f.c) * d2 + (6 - 2 * f.b)
                   : (-f.b - 6 * f.c) * d3 + (6 * f.b + 30 * f.c) * d2 + (-12 * f.b - 48 * f.c) * d +
                         (8 * f.b + 24 * f.c);
  }
  }
  return 0.0;
}

/// Share of the filter's integral that lies below x.
double below(const PixelFilter& f, double x) {
  constexpr int kCells = 40000;
  const double cell = 2.0 * f.radius / kCells;
  double part = 0.0;
  double whole = 0.0;
  for (int i = 0; i < kCells; ++i) {
    const double at = -f.radius + (i + 0.5) * cell;
    whole += shapeOf(f, at);
    part += at < x ? shapeOf(f, at) : 0.0;
  }
  return part / whole;
}

/// Means over the columns (or rows) of a square image of a dark and a bright half.
constexpr int kFilterEdge = 8;
constexpr double kBorder = 4.45; // pixels from the left or from the top
Film edgeImage(Trial& t, const PixelFilter& filter, bool upright) {
  const double at = kBorder / kFilterEdge * 2.0 - 1.0;
  SceneBuilder builder;
  if (upright)
    builder.quad({-9.0, -9.0, -1.0}, {at, -9.0, -1.0}, {at, 9.0, -1.0}, {-9.0, 9.0, -1.0},
                 emitter(Vec3f(1.0F)));
  else
    builder.quad({-9.0, -at, -1.0}, {9.0, -at, -1.0}, {9.0, 9.0, -1.0}, {-9.0, 9.0, -1.0},
                 emitter(Vec3f(1.0F)));
  Scene scene = builder.camera(lookAt(Vec3d(0.0), {0.0, 0.0, -1.0}, 90.0)).build();
  scene.filter = filter;
  return t.render(scene, {.width = kFilterEdge, .height = kFilterEdge, .frames = 2048}).film;
}

void edgeByFilter(Trial& t) {
  for (const auto& [name, filter] : kFilters) {
    for (const bool upright : {true, false}) {
      const Film film = edgeImage(t, filter, upright);
      for (int i = 0; i < kFilterEdge; ++i) {
        double mean = 0.0;
        double variance = 0.0;
        for (int j = 0; j < kFilterEdge; ++j) {
          const PixelMoments& p = upright ? film.at(i, j) : film.at(j, i);
          mean += p.mean.x / kFilterEdge;
          variance += p.varianceOfMean().x / (kFilterEdge * kFilterEdge);
        }
        const double expected = below(filter, kBorder - (i + 0.5));
        const double error = std::sqrt(variance);
        const std::string figures = fmt::format("{}: {} {} is {:.5f} +- {:.1g}, expected {:.5f}", name,
                                                upright ? "column" : "row", i, mean, error, expected);
        t.expect(std::abs(mean - expected) <= 4.0 * error + 1e-6, figures);
        if (t.isShipped())
          t.expect(error < 0.012, figures + ": too noisy to tell");
      }
    }
  }
  // What the edge's image is known for: it undershoots and overshoots.
  const PixelFilter& mitchell = kFilters[3].filter;
  t.expect(below(mitchell, kBorder - 3.5) > 1.01 && below(mitchell, kBorder - 5.5) < -0.01,
           "no negative lobes in the expectation");
}

/// Weights have a mean of 1, and vary little where no lobe is negative: an even surface stays even.
void evenByFilter(Trial& t) {
  for (const auto& [name, filter] : kFilters) {
    Scene scene = SceneBuilder()
                      .floor(Vec3d(0.0), 9.0, emitter({3.0F, 2.0F, 1.0F}))
                      .camera(lookAt({0.1, 2.0, 0.2}, Vec3d(0.0), 30.0))
                      .build();
    scene.filter = filter;
    const Film film = t.render(scene, {.width = 32, .height = 32, .frames = 200}).film;
    t.expectMean(film, {3.0, 2.0, 1.0}, 0.01, name);
    if (filter.shape != PixelFilter::Shape::Mitchell) {
      t.expect(sampleVariance(film).z < 0.04,
               fmt::format("{}: weights have a variance of {:.3g}", name, sampleVariance(film).z));
    }
  }
}

constexpr Check kFilterChecks[] = {
    {"evenByFilter", evenByFilter},
    {"edgeByFilter", edgeByFilter},
};

} // namespace

std::span<const Check> filterChecks() { return kFilterChecks; }

} // namespace vkpt::test
