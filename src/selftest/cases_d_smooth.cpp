// Mirror, metal and glass against Fresnel's equations.
#include "selftest/case.h"
#include "selftest/scene_builder.h"
#include "selftest/statistics.h"

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
      t.atMost(fmt::format("silver at {} degrees: roundings off", degrees),
               std::abs(mean - expected[c]) / (0x1p-24 * expected[c]), kFresnelOperations,
               fmt::format("{:.8g}, expected {:.8g}", mean, expected[c]));
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

/// Indices from next to 1 to 1e6: nothing is lost in white surroundings.
void extremeIndices(Trial& t) {
  for (const float ior : {1.0001F, 3.0F, 100.0F, 1e6F}) {
    const Scene scene = SceneBuilder()
                            .box({-0.5, -0.4, -0.6}, {0.6, 0.5, 0.4}, Facing::Outward, glass(ior))
                            .camera(lookAt({1.5, 1.2, 2.0}, {0.0, 0.0, 0.0}, 40.0))
                            .background(Vec3f(1.0F))
                            .build();
    t.expectConstant(t.render(scene, {.width = 32, .height = 32, .frames = 8}).film, Vec3d(1.0), 0,
                     fmt::format("index {:g}", ior));
  }
}

/// Reflectance of a row of interfaces, light going to and fro between them: each new one before those behind
/// it.
double stackReflectance(const std::vector<double>& each) {
  double behind = 0.0;
  for (auto r = each.rbegin(); r != each.rend(); ++r)
    behind = *r + (1.0 - *r) * (1.0 - *r) * behind / (1.0 - *r * behind);
  return behind;
}

/// A slab of one glass in a slab of another, at 40 degrees: four interfaces.
void nestedSlabs(Trial& t) {
  const double outer = 1.3;
  const double inner = 1.9;
  const double sinI = std::sin(radians(40.0));
  Material core = glass(static_cast<float>(inner));
  core.extIor = static_cast<float>(outer);
  SceneBuilder builder;
  plate(builder, 0.0, 50.0, true, glass(static_cast<float>(outer)));
  plate(builder, -0.1, 50.0, true, core);
  plate(builder, -0.2, 50.0, false, core);
  plate(builder, -0.3, 50.0, false, glass(static_cast<float>(outer)));
  plate(builder, 9.0, 500.0, false, emitter({1.0F, 0.0F, 0.0F}));
  plate(builder, -9.0, 500.0, true, emitter({0.0F, 1.0F, 0.0F})).camera(plateCamera(40.0));
  const Film film = t.render(builder.build(), {.width = 64, .height = 64, .frames = 64}).film;
  const double first = exactFresnelDielectric(std::sqrt(1.0 - sinI * sinI), outer);
  const double sinO = sinI / outer;
  const double second = exactFresnelDielectric(std::sqrt(1.0 - sinO * sinO), inner / outer);
  const double r = stackReflectance({first, second, second, first});
  t.expectMean(film, {r, 1.0 - r, 0.0}, 0.02);
}

/// Two glass boxes that share a face: which of the two is met first is not defined by the model, but it is
/// the same in every run, and nothing breaks.
void touchingGlass(Trial& t) {
  const Scene scene = SceneBuilder()
                          .box({-1.0, -0.5, -0.5}, {0.0, 0.5, 0.5}, Facing::Outward, glass(1.5F))
                          .box({0.0, -0.5, -0.5}, {1.0, 0.5, 0.5}, Facing::Outward, glass(1.5F))
                          .camera(lookAt({2.0, 0.8, 2.0}, {0.0, 0.0, 0.0}, 50.0))
                          .background(Vec3f(1.0F))
                          .build();
  const RenderSetup setup{.width = 32, .height = 32, .frames = 16, .seed = t.seed("touching")};
  const Film once = t.render(scene, setup).film;
  t.expect(identical(once, t.render(scene, setup).film), "two renders differ");
  t.atMost("deviation of the mean from 1", std::abs(estimateOf(once).mean.x - 1.0), 0.01);
}

/// Into the corner of a glass cube from within: every face reflects totally, three faces send the ray back,
/// and only the far cap ends it.
void trappedLight(Trial& t) {
  const Scene scene = SceneBuilder()
                          .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Outward, glass(1.5F))
                          .camera(lookAt({0.1, -0.2, 0.05}, {1.1, 0.8, 1.05}, kPointFov))
                          .background(Vec3f(1.0F))
                          .build();
  const Rendered r = t.render(scene, {.width = 8, .height = 8, .frames = 1});
  t.expectConstant(r.film, Vec3d(0.0), 0, "light that can't get in");
  t.atLeast("paths of 64 that the cap ended", static_cast<double>(r.counters.cappedPaths), 64.0);
}

constexpr Case kSmoothCases[] = {
    {"d4-slab",
     "a slab of glass reflects 2 R / (1 + R) and lets the rest through, inner reflections included",
     glassSlab},
    {"d4-refraction", "glass lets 1 - R through, where Snell's law says", refractedRay},
    {"d5-extreme-indices", "glass of index 1.0001 to 1e6 loses nothing", extremeIndices},
    {"d6-nested", "one glass in another against the sum over four interfaces", nestedSlabs},
    {"d6-touching", "two glass boxes that share a face are clean and the same in every run", touchingGlass},
    {"d7-trapped-light", "light that total reflection traps is ended, counted, and no fault", trappedLight},
    {"d8-white-furnace", "a glass box in surroundings of radiance 1 can't be seen", glassInWhite},
    {"d9-mirror", "a mirror reflects its reflectance, at every angle", mirrorOfEmitter},
    {"d9-metal", "silver reflects by Fresnel's equations for a complex index", metalPlate},
};

} // namespace

std::span<const Case> smoothCases() { return kSmoothCases; }

} // namespace vkpt::selftest
