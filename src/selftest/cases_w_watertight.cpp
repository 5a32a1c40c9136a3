// No ray slips between triangles, whatever it aims at.
#include "selftest/case.h"
#include "selftest/leaks.h"
#include "selftest/meshes.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::selftest {
namespace {

const Material kBlack = diffuse(Vec3f(0.0F));

double sumOf(const Film& film) {
  double sum = 0.0;
  for (const PixelMoments& p : film.pixels)
    sum += p.mean.x + p.mean.y + p.mean.z;
  return sum;
}

void leakCase(Trial& t) { lightOutsideStaysOutside(t, 1e7); }

/// Pixels so small that neighbouring rays differ by few ulp, about points that several triangles share.
void aimedRays(Trial& t) {
  const RoughSphere sphere{12, 24};
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    const Vec3d corner = sphere.vertex(2 + i, 3 * i);
    const Vec3d next = sphere.vertex(3 + i, 3 * i + (i % 2));
    SceneBuilder builder;
    sphere.addTo(builder, kBlack);
    const Vec3d target = i % 2 == 0 ? corner : 0.5 * (corner + next);
    builder.background(Vec3f(1.0F)).camera(lookAt({0.11, -0.07, 0.05}, target, kPointFov));
    const Scene scene = builder.build();
    EffectSet effects = detectEffects(scene, {});
    effects.set(Effect::Background); // a closed mesh is known to hide it
    sum += sumOf(t.render(scene, {.width = 64, .height = 64, .frames = 8, .effects = effects}).film);
  }
  t.atMost("light through vertices and edges", sum, 0.0, "131072 rays within 1e-5 of one");
}

/// A wall of squares whose edges fall on the borders of the pixels.
void latticeWall(Trial& t) {
  constexpr int kSquares = 64;
  SceneBuilder builder;
  for (int y = 0; y < kSquares; ++y) {
    for (int x = 0; x < kSquares; ++x) {
      const auto at = [](int i) { return 2.0 * i / kSquares - 1.0; };
      builder.quad({at(x), at(y), -1.0}, {at(x + 1), at(y), -1.0}, {at(x + 1), at(y + 1), -1.0},
                   {at(x), at(y + 1), -1.0}, kBlack);
    }
  }
  builder.background(Vec3f(1.0F)).camera(lookAt(Vec3d(0.0), {0.0, 0.0, -1.0}, 90.0));
  const Film film = t.render(builder.build(), {.width = 128, .height = 128, .frames = 32}).film;
  t.atMost("light through the wall", sumOf(film), 0.0, "524288 rays");
}

/// Vertices in the middle of other triangles' edges, where no floats lie on the line: the model has gaps of
/// an ulp.
void tJunctions(Trial& t) {
  constexpr int kStrips = 40;
  SceneBuilder builder;
  const Vec3d left(-1.3, 0.013, -1.0);
  const Vec3d right(1.3, 0.171, -1.07);
  builder.quad({-2.0, -2.0, -1.0}, {2.0, -2.0, -1.0}, right, left, kBlack);
  const auto at = [&](int i) { return glm::mix(left, right, i / static_cast<double>(kStrips)); };
  for (int i = 0; i < kStrips; ++i)
    builder.triangle(at(i), at(i + 1), {0.0, 3.0, -1.0}, kBlack);
  builder.background(Vec3f(1.0F)).camera(lookAt(Vec3d(0.0), {0.0, 0.09, -1.0}, 60.0));
  const Film film = t.render(builder.build(), {.width = 256, .height = 64, .frames = 32}).film;
  // Rows about the seam only.
  double sum = 0.0;
  int pixels = 0;
  for (int y = 24; y < 40; ++y) {
    for (int x = 0; x < film.width; ++x, ++pixels)
      sum += film.at(x, y).mean.x;
  }
  t.atMost("share of rays through the seam", sum / pixels, 1e-5, "gaps of the model's own");
}

constexpr Case kWatertightCases[] = {
    {"w1-no-light-through-a-closed-mesh",
     "1e7 rays within a closed rough mesh see nothing of the lights outside", leakCase},
    {"w2-rays-at-vertices-and-edges", "rays aimed at shared vertices and edges hit one of the triangles",
     aimedRays},
    {"w3-wall-on-the-lattice-of-pixels", "a wall whose edges are the borders of pixels is closed",
     latticeWall},
    {"w4-vertices-on-edges", "where a model has gaps of an ulp, few rays pass", tJunctions},
};

} // namespace

void lightOutsideStaysOutside(Trial& t, double rays) {
  const RoughSphere sphere{48, 96};
  const auto look = [&](float albedo, std::uint32_t bounces, double raysOfSample, double wanted) {
    SceneBuilder builder;
    sphere.addTo(builder, diffuse(Vec3f(albedo)));
    builder.box(Vec3d(-10.0), Vec3d(10.0), Facing::Inward, emitter(Vec3f(1.0F)))
        .camera(lookAt({0.2, 0.1, -0.1}, {1.0, 0.3, 0.2}, 120.0));
    constexpr int kEdge = 256;
    const double frames = std::ceil(wanted / (raysOfSample * kEdge * kEdge));
    return t.render(builder.build(), {.estimator = withBounces(withoutRoulette(misSampling()), bounces),
                                      .width = kEdge,
                                      .height = kEdge,
                                      .frames = static_cast<std::uint64_t>(frames)});
  };
  const Rendered seen = look(0.0F, 0, 1.0, rays);
  t.atMost("light that the eye saw", sumOf(seen.film), 0.0,
           fmt::format("{:.3g} rays", double(seen.counters.raysClosest)));
  // Points in narrow folds of the mesh: a ray starts an error bound off its surface, which there may be
  // beyond the next.
  const Rendered scattered = look(0.5F, 8, 12.0, 0.1 * rays);
  const double traced = static_cast<double>(scattered.counters.raysClosest + scattered.counters.raysShadow);
  t.atMost("share of light that was scattered in", sumOf(scattered.film) / 3.0 / (256.0 * 256.0), 1e-5,
           fmt::format("{:.3g} rays in folds", traced));
}

std::span<const Case> watertightCases() { return kWatertightCases; }

} // namespace vkpt::selftest
