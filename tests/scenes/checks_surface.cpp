// What a surface is like: its sides, its textures, what lies behind it.
#include "scenes/scene_extras.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

/// A one-sided plate in surroundings of radiance 1: its front as a two-sided one's, its back black; what it
/// emits leaves its front alone, as ever.
void oneSided(Trial& t) {
  const auto look = [&](Material material, bool front, bool twoSided) {
    material.twoSided = twoSided;
    const Scene scene = SceneBuilder()
                            .floor(Vec3d(0.0), 1.0, material)
                            .camera(lookAt({0.3, front ? 2.0 : -2.0, 0.2}, Vec3d(0.0), 20.0))
                            .background(Vec3f(1.0F))
                            .build();
    return t.render(scene, {.estimator = misSampling(), .frames = 8}).film;
  };
  const Vec3d albedo(0.5, 0.25, 0.75);
  const Vec3d emission(0.0, 0.25, 0.5);
  const Material shining = diffuse(Vec3f(albedo), Vec3f(emission));
  const Material opaque[] = {shining, phong(Vec3f(0.25F), Vec3f(0.5F), 10.0F), mirror(Vec3f(0.5F)),
                             metal(Vec3f(0.2F), Vec3f(3.0F))};
  for (const Material& m : opaque)
    t.expectConstant(look(m, false, false), Vec3d(0.0), 0, "back of a one-sided surface");
  t.expectConstant(look(shining, false, true), albedo, 2, "back of a two-sided surface");
  for (const bool twoSided : {false, true})
    t.expectConstant(look(shining, true, twoSided), albedo + emission, 2, "front");
}

/// Glass lets light through from either side, whatever else is one-sided.
void glassHasBothSides(Trial& t) {
  Material pane = glass(1.3F);
  pane.twoSided = false;
  Material plate = diffuse(Vec3f(0.5F));
  plate.twoSided = false;
  const Scene scene = SceneBuilder()
                          .box({-0.5, -0.4, -0.6}, {0.6, 0.5, 0.4}, Facing::Outward, pane)
                          .floor({0.0, 50.0, 0.0}, 1e-3, plate)
                          .camera(lookAt({1.5, 1.2, 2.0}, Vec3d(0.0), 40.0))
                          .background(Vec3f(1.0F))
                          .build();
  const EstimatorSettings settings = withoutRoulette(misSampling());
  const Film film = t.render(scene, {.estimator = settings, .frames = 8}).film;
  t.expectConstant(film, Vec3d(1.0), 0, "white surroundings");
}

/// Light that comes to a one-sided floor from above does not come through it, nor is its back lit by it.
void oneSidedByLights(Trial& t) {
  Material material = diffuse(Vec3f(0.5F));
  material.twoSided = false;
  for (const bool front : {true, false}) {
    SceneBuilder builder;
    builder.floor(Vec3d(0.0), 1.0, material);
    if (front)
      builder.ceiling({0.0, 1.0, 0.0}, 0.3, emitter(Vec3f(1.0F)));
    else
      builder.floor({0.0, -1.0, 0.0}, 0.3, emitter(Vec3f(1.0F)));
    builder.camera(lookAt({0.6, front ? 0.8 : -0.8, 0.2}, Vec3d(0.0), kPointFov));
    const Film film =
        t.render(builder.build(), {.estimator = misSampling(), .width = 32, .height = 32, .frames = 32}).film;
    const double h = 0.3;
    const double irradiance =
        polygonIrradiance({{-h, 1, -h}, {h, 1, -h}, {h, 1, h}, {-h, 1, h}}, Vec3d(0.0), {0.0, 1.0, 0.0});
    t.expectMean(film, Vec3d(front ? 0.5 * irradiance / std::numbers::pi : 0.0), 0.01,
                 front ? "front" : "back");
  }
}

/// Bilinear between the centres of texels, repeated; u to the right, v upwards, row 0 on top.
Vec3d bilinear(const Texture& texture, double u, double v) {
  const double x = u * texture.width - 0.5;
  const double y = (1.0 - v) * texture.height - 0.5;
  const auto at = [&](int column, int row) {
    const auto wrap = [](int i, int n) { return (i % n + n) % n; };
    return Vec3d(texture.texels[static_cast<std::size_t>(wrap(row, texture.height) * texture.width +
                                                         wrap(column, texture.width))]);
  };
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const double fx = x - x0;
  const double fy = y - y0;
  return glm::mix(glm::mix(at(x0, y0), at(x0 + 1, y0), fx), glm::mix(at(x0, y0 + 1), at(x0 + 1, y0 + 1), fx),
                  fy);
}

/// A textured square fills the image, head-on under a white sky: each pixel is albedo times the texture over
/// it.
void textured(Trial& t) {
  const Texture texture =
      textureOf(3, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5F, 0.5F, 0}, {0, 0.5F, 1}, {1, 1, 1}});
  constexpr int kEdge = 16;
  constexpr int kPoints = 32; // of a pixel, either way
  const Vec3d reflectance(0.5, 0.75, 1.0);
  // From below 0 to above 1, and not square.
  const Vec2f lower(-0.25F, -0.5F);
  const Vec2f upper(1.0F, 2.0F);
  Scene scene = SceneBuilder()
                    .quad({-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, diffuse(Vec3f(reflectance)))
                    .camera(lookAt(Vec3d(0.0), {0.0, 0.0, -1.0}, 90.0))
                    .background(Vec3f(1.0F))
                    .build();
  textureLastQuad(scene, texture, {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}});
  const Film film =
      t.render(scene,
               {.estimator = withBounces(bsdfSampling(), 1), .width = kEdge, .height = kEdge, .frames = 256})
          .film;
  for (int y = 0; y < kEdge; ++y) {
    for (int x = 0; x < kEdge; ++x) {
      Vec3d expected(0.0);
      for (int i = 0; i < kPoints * kPoints; ++i) {
        const double u = (x + (i % kPoints + 0.5) / kPoints) / kEdge;
        const double v = 1.0 - (y + (i / kPoints + 0.5) / kPoints) / kEdge;
        expected += reflectance *
                    bilinear(texture, lower.x + u * (upper.x - lower.x), lower.y + v * (upper.y - lower.y)) /
                    double{kPoints * kPoints};
      }
      const PixelMoments& p = film.at(x, y);
      const Vec3d bound = 5.0 * glm::sqrt(p.varianceOfMean()) + 1e-3; // half floats, quadrature
      t.expect(glm::all(glm::lessThanEqual(glm::abs(p.mean - expected), bound)),
               fmt::format("pixel ({}, {}) is {:.4f} {:.4f} {:.4f}, expected {:.4f} {:.4f} {:.4f}", x, y,
                           p.mean.x, p.mean.y, p.mean.z, expected.x, expected.y, expected.z));
    }
  }
}

/// A slab of absorbing glass before a white sky, all reflections within it summed: with index 1 exp(-s d).
void absorbingSlab(Trial& t) {
  const double thickness = 0.2;
  for (const float ior : {1.0F, 1.5F}) {
    for (const double degrees : {0.0, 60.0}) {
      Material m = glass(ior);
      m.absorption = {0.5F, 2.0F, 8.0F};
      const double a = degrees * std::numbers::pi / 180.0;
      const Scene scene = SceneBuilder()
                              .floor(Vec3d(0.0), 2.0, m)
                              .ceiling({0.0, -thickness, 0.0}, 2.0, m)
                              .camera(lookAt({2.0 * std::sin(a), 2.0 * std::cos(a), 0.0}, Vec3d(0.0),
                                             kPointFov, {0.0, 0.0, 1.0}))
                              .background(Vec3f(1.0F))
                              .build();
      EstimatorSettings settings = misSampling();
      settings.splitDepth = 16;
      const Film film = t.render(scene, {.estimator = settings, .frames = 4}).film;
      const double sinT = std::sin(a) / double{ior};
      const double r = exactFresnelDielectric(std::cos(a), double{ior});
      const Vec3d pass = glm::exp(-Vec3d(m.absorption) * (thickness / std::sqrt(1.0 - sinT * sinT)));
      const Vec3d through = (1.0 - r) * (1.0 - r) / (1.0 - r * r * pass * pass);
      const Vec3d expected = r + through * pass + through * r * pass * pass;
      const Vec3d off = glm::abs(film.at(3, 3).mean / expected - 1.0);
      t.expect(std::max({off.x, off.y, off.z}) < 2e-4, // rays start off the surface

               fmt::format("index {} at {} degrees: {:.6g} {:.6g} {:.6g}, expected {:.6g} {:.6g} {:.6g}", ior,
                           degrees, film.at(3, 3).mean.x, film.at(3, 3).mean.y, film.at(3, 3).mean.z,
                           expected.x, expected.y, expected.z));
    }
  }
}

constexpr Check kSurfaceChecks[] = {
    {"oneSided", oneSided}, {"oneSidedByLights", oneSidedByLights}, {"glassHasBothSides", glassHasBothSides},
    {"textured", textured}, {"absorbingSlab", absorbingSlab},
};

} // namespace

std::span<const Check> surfaceChecks() { return kSurfaceChecks; }

} // namespace vkpt::test
