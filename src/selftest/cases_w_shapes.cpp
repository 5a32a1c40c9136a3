// Shapes at the limits: boxes without thickness, centroids that coincide, sizes far apart.
#include "selftest/case.h"
#include "selftest/meshes.h"
#include "selftest/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vkpt::selftest {
namespace {

/// Rays exactly along an axis, from an eye whose coordinates are those of boxes: 0 * infinity in a slab test.
void raysAlongAxes(Trial& t) {
  constexpr double kNoFov = 1e-60; // every ray is the axis, to the last bit
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {axis == 1 ? -1.0 : 1.0}) {
      SceneBuilder builder;
      Vec3d u(0.0);
      Vec3d v(0.0);
      Vec3d w(0.0);
      u[(axis + 1) % 3] = 1.0;
      v[(axis + 2) % 3] = 1.0;
      w[axis] = sign;
      for (int x = -4; x < 4; ++x) {
        for (int y = -4; y < 4; ++y) {
          const auto at = [&](int i, int j) { return w + double(i) * u + double(j) * v; };
          builder.quad(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1), diffuse(Vec3f(0.0F)));
          builder.quad(at(x, y) - 2.0 * w, at(x, y + 1) - 2.0 * w, at(x + 1, y + 1) - 2.0 * w,
                       at(x + 1, y) - 2.0 * w, diffuse(Vec3f(0.0F)));
        }
      }
      builder.background(Vec3f(1.0F)).camera(lookAt(Vec3d(0.0), w, kNoFov, u));
      const Film film = t.render(builder.build(), {.width = 8, .height = 8, .frames = 4}).film;
      t.expectConstant(film, Vec3d(0.0), 0, fmt::format("along {}{}", sign < 0 ? '-' : '+', "xyz"[axis]));
    }
  }
}

/// Of twins the first is seen, in every tile, whatever the order of the tree; of overlapping faces in one
/// plane, whose distances are rounded apart, each ray sees one.
void coplanarFaces(Trial& t) {
  const auto look = [&](double growth) {
    SceneBuilder builder;
    for (int i = 0; i < 20; ++i) {
      const double r = 4.0 + growth * i;
      builder.triangle({-r, -r, 0}, {r, -r, 0}, {0, r, 0},
                       emitter(i == 0 ? Vec3f(1.0F, 0.0F, 0.5F) : Vec3f(0.0F, 1.0F, 0.5F)));
    }
    builder.camera(lookAt({0.1, 0.2, 3.0}, {0.1, 0.2, 0.0}, 30.0));
    return t.render(builder.build(), {.width = 64, .height = 64, .frames = 8}).film;
  };
  t.expectConstant(look(0.0), {1.0, 0.0, 0.5}, 0, "the first of twenty twins");
  double worst = 0.0;
  for (const PixelMoments& p : look(0.05).pixels)
    worst = std::max({worst, std::abs(p.mean.x + p.mean.y - 1.0), std::abs(p.mean.z - 0.5)});
  t.atMost("faces in one plane: seen more or less than once", worst, 8.0 * 0x1p-24, "roundings of a mean");
}

/// A lamp two long and 1e-5 wide above a floor.
void slivers(Trial& t) {
  const Vec3d a(-1.0, 1.0, 0.2);
  const Vec3d b(1.0, 1.0, 0.3);
  const Vec3d c(0.0, 1.0, 0.25 + 1e-5);
  constexpr float kSliverRadiance = 1e5F;
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F)))
      .triangle(a, b, c, emitter(Vec3f(kSliverRadiance)))
      .camera(lookAt({0.5, 0.7, -0.4}, Vec3d(0.0), kPointFov));
  const Scene scene = builder.build();
  const auto& p = scene.positions; // the floats that are rendered
  const std::size_t n = p.size();
  const Vec3d floorPoint = -scene.origin;
  const double irradiance =
      polygonIrradiance({Vec3d(p[n - 3]), Vec3d(p[n - 2]), Vec3d(p[n - 1])}, floorPoint, {0.0, 1.0, 0.0});
  const EstimatorSettings settings = withBounces(lightSampling(), 1);
  const Film film = t.render(scene, {.estimator = settings, .width = 64, .height = 64, .frames = 16}).film;
  t.expectMean(film, Vec3d(kSliverRadiance * 0.5 * irradiance / std::numbers::pi), 0.01,
               "a sliver of a lamp");
}

/// Trees over what no plane parts: everything is still found, and nothing is given up.
void hardTrees(Trial& t) {
  const auto look = [&](const char* what, const std::function<void(SceneBuilder&)>& add, double z) {
    SceneBuilder builder;
    add(builder);
    builder.camera(lookAt({0.013, 0.021, z}, {0.013, 0.021, 0.0}, 10.0));
    t.expectConstant(t.render(builder.build(), {.width = 32, .height = 32, .frames = 4}).film, Vec3d(1.0), 0,
                     what);
  };
  const Material lamp = emitter(Vec3f(1.0F));
  look(
      "concentric triangles", [&](SceneBuilder& b) { addConcentric(b, 1000, lamp); }, 2.0);
  look(
      "a fan of slivers", [&](SceneBuilder& b) { addSliverFan(b, 20000, 3.0, lamp); }, 2.0);
  look(
      "sizes in a geometric progression",
      [&](SceneBuilder& b) {
        for (int i = 0; i < 60; ++i) {
          const double r = std::ldexp(1.0, i - 30);
          b.quad({-r, -r, -r}, {r, -r, -r}, {r, r, -r}, {-r, r, -r}, lamp);
        }
      },
      2.0);
}

/// A floor of 1e-5 under a light of that size, in a hall of 2e7.
void mixedUnits(Trial& t) {
  constexpr double kSmall = 1e-5;
  constexpr double kLarge = 1e7;
  constexpr Vec3f kLampRadiance(3.0F, 2.0F, 1.0F);
  SceneBuilder builder;
  builder.floor(Vec3d(0.0), 4.0 * kSmall, diffuse(Vec3f(0.5F)))
      .ceiling({0.0, kSmall, 0.0}, kSmall, emitter(kLampRadiance))
      .box(Vec3d(-kLarge), Vec3d(kLarge), Facing::Inward, diffuse(Vec3f(0.5F)))
      .camera(lookAt({3.0 * kSmall, 0.5 * kSmall, 0.0}, Vec3d(0.0), kPointFov));
  const double h = 1.0;
  const double irradiance =
      polygonIrradiance({{-h, 1, -h}, {h, 1, -h}, {h, 1, h}, {-h, 1, h}}, Vec3d(0.0), {0.0, 1.0, 0.0});
  const EstimatorSettings settings = withBounces(misSampling(), 1);
  const Film film =
      t.render(builder.build(), {.estimator = settings, .width = 64, .height = 64, .frames = 32}).film;
  t.expectMean(film, Vec3d(kLampRadiance) * (0.5 * irradiance / std::numbers::pi), 0.01,
               "a floor of 1e-5 in 2e7");
}

/// One triangle, one that is black, and no light at all.
void leastScenes(Trial& t) {
  const auto one = [](const Material& material) {
    SceneBuilder builder;
    builder.triangle({-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, material)
        .camera(lookAt({0, 0, 5}, Vec3d(0.0), 5.0));
    return builder;
  };
  SceneBuilder lit = one(diffuse(Vec3f(0.75F)));
  lit.background(Vec3f(1.0F)).camera(lookAt({-0.5, -0.5, 5.0}, {-0.5, -0.5, 0.0}, 5.0));
  const EstimatorSettings settings = withBounces(bsdfSampling(), 1);
  t.expectConstant(t.render(lit.build(), {.estimator = settings}).film, Vec3d(0.75), 2,
                   "one triangle under a white sky");
  t.expectConstant(t.render(one(diffuse(Vec3f(0.75F))).build(), {}).film, Vec3d(0.0), 0, "no light");
  const Film lamp =
      t.render(one(emitter(Vec3f(2.0F))).build(), {.width = 64, .height = 64, .frames = 64}).film;
  // The diagonal parts the image: half of it sees the lamp.
  t.expectMean(lamp, Vec3d(1.0), 0.03, "one emitter");
}

constexpr Case kShapeCases[] = {
    {"w5-slivers", "a lamp 1e-5 wide gives the light of its polygon", slivers},
    {"w9-faces-in-one-plane", "of twins the first is seen, everywhere", coplanarFaces},
    {"w10-rays-along-axes", "rays along an axis from within the planes of flat boxes hit", raysAlongAxes},
    {"w11-trees-that-no-plane-parts", "concentric, fanned and nested triangles are found by every ray",
     hardTrees},
    {"w12-mixed-units", "1e-5 and 1e7 in one scene: the small floor has its light", mixedUnits},
    {"w13-least-scenes", "one triangle, and no light, are scenes too", leastScenes},
};

} // namespace

std::span<const Case> shapeCases() { return kShapeCases; }

} // namespace vkpt::selftest
