// Mirror, metal and glass against Fresnel's equations.
#include "selftest/case.h"
#include "selftest/scene_builder.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace vkpt::selftest {
namespace {

constexpr Vec3f kRadiance(3.0F, 2.0F, 1.0F);

/// Cornell's plate of silver: refractiveindex.info, Johnson and Christy 1972, at 630, 532 and 465 nm.
constexpr Vec3f kSilverEta(0.0552F, 0.0540F, 0.0420F);
constexpr Vec3f kSilverK(4.2800F, 3.4290F, 2.3500F);

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Seen at `degrees` from the normal (+z), from the distance 4, as one point.
Camera plateCamera(double degrees) {
  const double a = radians(degrees);
  return lookAt({4.0 * std::sin(a), 0.0, 4.0 * std::cos(a)}, {0.0, 0.0, 0.0}, kPointFov);
}

/// A large square in a plane of constant z; `up`: its front faces +z.
SceneBuilder& plate(SceneBuilder& builder, double z, double halfEdge, bool up, const Material& material) {
  const double h = halfEdge;
  return up ? builder.quad({-h, -h, z}, {h, -h, z}, {h, h, z}, {-h, h, z}, material)
            : builder.quad({-h, -h, z}, {-h, h, z}, {h, h, z}, {h, -h, z}, material);
}

Film reflectionIn(Trial& t, const Material& material, double degrees) {
  SceneBuilder builder;
  plate(builder, 0.0, 1.0, true, material);
  plate(builder, 8.0, 100.0, false, emitter(kRadiance)).camera(plateCamera(degrees));
  return t.render(builder.build(), {.frames = 20}).film;
}

void mirrorOfEmitter(Trial& t) {
  const Vec3f reflectance(0.9F, 0.6F, 0.3F);
  for (const double degrees : {0.0, 50.0}) {
    t.expectConstant(reflectionIn(t, mirror(reflectance), degrees), Vec3d(reflectance) * Vec3d(kRadiance), 2,
                     fmt::format("mirror at {} degrees", degrees));
  }
}

/// Float rounding of Fresnel's formulas: some ten operations on numbers of the size of k^2.
constexpr int kFresnelOperations = 300;

void metalPlate(Trial& t) {
  for (const double degrees : {0.0, 45.0, 80.0}) {
    const Film film = reflectionIn(t, metal(kSilverEta, kSilverK), degrees);
    Vec3d expected;
    for (int c = 0; c < 3; ++c) {
      expected[c] = kRadiance[c] * exactFresnelConductor(std::cos(radians(degrees)), double{kSilverEta[c]},
                                                         double{kSilverK[c]});
    }
    // The pixel's angles differ by kPointFov, too little to see in the mean; so do not ask for equal samples.
    for (int c = 0; c < 3; ++c) {
      const double mean = film.at(0, 0).mean[c];
      t.expect(std::abs(mean - expected[c]) <= kFresnelOperations * 0x1p-24 * expected[c],
               fmt::format("silver at {} degrees: {:.8g}, expected {:.8g}", degrees, mean, expected[c]));
    }
  }
}

/// Reflected light is red, transmitted light green: with R of one interface, 2 R / (1 + R) and
/// (1 - R) / (1 + R), the sum over all internal reflections.
void glassSlab(Trial& t) {
  for (const double degrees : {0.0, 60.0}) {
    SceneBuilder builder;
    plate(builder, 0.0, 50.0, true, glass(1.5F));
    plate(builder, -0.2, 50.0, false, glass(1.5F));
    plate(builder, 9.0, 500.0, false, emitter({1.0F, 0.0F, 0.0F}));
    plate(builder, -9.0, 500.0, true, emitter({0.0F, 1.0F, 0.0F})).camera(plateCamera(degrees));
    const Film film = t.render(builder.build(), {.width = 64, .height = 64, .frames = 100}).film;
    const double r = exactFresnelDielectric(std::cos(radians(degrees)), 1.5);
    t.expectMean(film, {2.0 * r / (1.0 + r), (1.0 - r) / (1.0 + r), 0.0}, 0.02,
                 fmt::format("slab at {} degrees", degrees));
  }
}

/// A small emitter in glass, exactly where Snell's law sends the ray.
void refractedRay(Trial& t) {
  const double degrees = 50.0;
  const double sinT = std::sin(radians(degrees)) / 1.5;
  const double x = -sinT / std::sqrt(1.0 - sinT * sinT);
  SceneBuilder builder;
  plate(builder, 0.0, 50.0, true, glass(1.5F)).camera(plateCamera(degrees));
  builder.quad({x - 0.01, -0.01, -1.0}, {x + 0.01, -0.01, -1.0}, {x + 0.01, 0.01, -1.0},
               {x - 0.01, 0.01, -1.0}, emitter(kRadiance));
  const Film film = t.render(builder.build(), {.width = 64, .height = 64, .frames = 16}).film;
  t.expectMean(film, Vec3d(kRadiance) * (1.0 - exactFresnelDielectric(std::cos(radians(degrees)), 1.5)),
               0.01);
}

/// In surroundings of radiance 1 glass can't be seen: what it takes away here it adds there.
void glassInWhite(Trial& t) {
  const Scene scene = SceneBuilder()
                          .box({-0.5, -0.4, -0.6}, {0.6, 0.5, 0.4}, Facing::Outward, glass(1.3F))
                          .camera(lookAt({1.5, 1.2, 2.0}, {0.0, 0.0, 0.0}, 40.0))
                          .background(Vec3f(1.0F))
                          .build();
  t.expectConstant(t.render(scene, {.width = 32, .height = 32, .frames = 20}).film, Vec3d(1.0), 0,
                   "white surroundings");
}

constexpr Case kCases[] = {
    {"d4-slab",
     "a slab of glass reflects 2 R / (1 + R) and lets the rest through, inner reflections included",
     glassSlab},
    {"d4-refraction", "glass lets 1 - R through, where Snell's law says", refractedRay},
    {"d8-white-furnace", "a glass box in surroundings of radiance 1 can't be seen", glassInWhite},
    {"d9-mirror", "a mirror reflects its reflectance, at every angle", mirrorOfEmitter},
    {"d9-metal", "silver reflects by Fresnel's equations for a complex index", metalPlate},
};

} // namespace

std::span<const Case> smoothCases() { return kCases; }

} // namespace vkpt::selftest
