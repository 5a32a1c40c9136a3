// Where rays start and end, at every scale and place; and shading normals that disagree with the surface.
#include "selftest/case.h"
#include "selftest/meshes.h"
#include "selftest/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vkpt::selftest {
namespace {

/// A closed room with a block that stands on its floor, the two in one plane, and a lamp just under the
/// ceiling.
SceneBuilder room() {
  SceneBuilder builder;
  builder.box(Vec3d(-1.0), Vec3d(1.0), Facing::Inward, diffuse({0.5F, 0.6F, 0.7F}))
      .box({-0.6, -1.0, -0.5}, {0.1, -0.2, 0.2}, Facing::Outward, diffuse(Vec3f(0.6F)))
      .ceiling({0.1, 0.99, 0.0}, 0.3, emitter({5.0F, 4.0F, 3.0F}))
      .camera(lookAt({0.8, 0.3, 0.9}, {-0.2, -0.5, -0.2}, 70.0));
  return builder;
}

Film picture(Trial& t, const Scene& scene) {
  const EstimatorSettings settings = withBounces(misSampling(), 4);
  return t.render(scene, {.estimator = settings, .width = 64, .height = 64, .frames = 48}).film;
}

/// The largest of all tiles' z in all channels.
double largestZ(const Film& a, const Film& b) {
  const std::vector<Estimate> tilesA = tileEstimates(a);
  const std::vector<Estimate> tilesB = tileEstimates(b);
  double worst = 0.0;
  for (std::size_t i = 0; i < tilesA.size(); ++i)
    worst = std::max(worst, maxAbs(welch(tilesA[i], tilesB[i])));
  return worst;
}
constexpr std::size_t kTileTests = std::size_t{64} * 3;

void sameAtEveryScale(Trial& t) {
  const SceneBuilder builder = room();
  const Film plain = picture(t, builder.build());
  struct Place {
    const char* name;
    double scale;
    Vec3d offset;
  };
  const Place places[] = {{"scale 1e-4", 1e-4, Vec3d(0.0)},
                          {"scale 1e6", 1e6, Vec3d(0.0)},
                          {"moved by 1e5", 1.0, {1e5, -7e4, 1.1e5}}};
  for (const Place& place : places) {
    const Film film = picture(t, builder.build(place.scale, place.offset));
    t.atMost(fmt::format("{}: largest z of a tile", place.name), largestZ(film, plain),
             sidakBound(3 * kTileTests));
    t.expectEqualMeans(film, plain, 0.01, place.name);
  }
  // Beyond, coordinates in double are as coarse as floats.
  const Film beyond = picture(t, builder.build(1.0, {1e9, -7e8, 1.1e9}));
  t.note("moved by 1e9: largest z of a tile", largestZ(beyond, plain));
}

/// The room at a distance from the middle of its scene, which is where coordinates are exact: the floats of
/// one at 1000 times its size are 1e-4 of it apart.
void farFromTheMiddle(Trial& t) {
  const Film plain = picture(t, room().build());
  const double meanOfPlain = estimateOf(plain).mean.y;
  for (const double distance : {100.0, 1000.0, 10000.0}) {
    SceneBuilder builder = room();
    const Vec3d there(2.0 * distance, 2.0 * distance, 2.0 * distance);
    builder.triangle(there, there + Vec3d(1, 0, 0), there + Vec3d(0, 1, 0), diffuse(Vec3f(0.5F)));
    const Film film = picture(t, builder.build());
    const std::string name = fmt::format("{:g} sizes from the middle", distance);
    const double off = estimateOf(film).mean.y / meanOfPlain - 1.0;
    if (distance < 1000.0)
      t.atMost(name + ": largest z of a tile", largestZ(film, plain), sidakBound(kTileTests),
               fmt::format("mean off by {:.2g}", off));
    else
      t.note(name + ": mean, relative difference", off);
  }
}

/// A lamp so close above a floor that the way is a thousandth and a hundred-thousandth of the lamp's size.
void lampClose(Trial& t) {
  for (const double gap : {1e-3, 1e-5}) {
    SceneBuilder builder;
    builder.floor(Vec3d(0.0), 1.0, diffuse(Vec3f(0.5F)))
        .ceiling({0.0, gap, 0.0}, 1.0, emitter(Vec3f(2.0F)))
        .camera(lookAt({3.0 * gap, 0.5 * gap, 0.0}, Vec3d(0.0), kPointFov));
    const double irradiance = polygonIrradiance({{-1, gap, -1}, {1, gap, -1}, {1, gap, 1}, {-1, gap, 1}},
                                                Vec3d(0.0), {0.0, 1.0, 0.0});
    const EstimatorSettings settings = withBounces(misSampling(), 1);
    const Film film =
        t.render(builder.build(), {.estimator = settings, .width = 32, .height = 32, .frames = 16}).film;
    t.expectMean(film, Vec3d(2.0 * 0.5 * irradiance / std::numbers::pi), 0.01, fmt::format("gap {:g}", gap));
  }
}

/// All walls emit: a ray that leaves through a corner or an edge is missed in the sum.
void cameraInACorner(Trial& t) {
  for (const double scale : {1e-4, 1e6}) {
    SceneBuilder builder;
    builder.box({-1.0, -1.1, -0.9}, {1.0, 1.2, 1.3}, Facing::Inward, diffuse(Vec3f(0.5F), Vec3f(1.0F)));
    const Vec3d corner(1.0, 1.2, 1.3);
    builder.camera(lookAt(corner - Vec3d(2e-4, 3e-4, 1e-4), corner, 120.0));
    const EstimatorSettings settings = withBounces(withoutRoulette(bsdfSampling()), 6);
    const Film film =
        t.render(builder.build(scale), {.estimator = settings, .width = 64, .height = 64, .frames = 16}).film;
    t.expectConstant(film, Vec3d(2.0 - std::ldexp(1.0, -6)), 0, fmt::format("scale {:g}", scale));
  }
}

/// An eye a hundred-thousandth above or below a floor sees the one, or does not. In the plane itself rounding
/// decides.
void cameraOnASurface(Trial& t) {
  const auto look = [&](double height, double toY) {
    SceneBuilder builder;
    builder.floor(Vec3d(0.0), 1.0, emitter(Vec3f(3.0F)))
        .background(Vec3f(1.0F))
        .camera(lookAt({0.1, height, 0.2}, {0.1, toY, 0.2}, 60.0, {0.0, 0.0, 1.0}));
    return t.render(builder.build(), {.frames = 8}).film;
  };
  t.expectConstant(look(1e-5, 1.0), Vec3d(1.0), 0, "up from above");
  t.expectConstant(look(1e-5, -1.0), Vec3d(3.0), 0, "down from above");
  t.expectConstant(look(-1e-5, -1.0), Vec3d(1.0), 0, "down from below");
  t.note("in the plane: mean of 1 and 3", estimateOf(look(0.0, -1.0)).mean.x);
}

/// Gives every triangle the normals of a sphere about the origin, in or out.
void makeRound(Scene& scene, float side) {
  for (Triangle& triangle : scene.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.normal[i] = static_cast<std::uint32_t>(scene.normals.size());
      scene.normals.push_back(side * glm::normalize(scene.positions[triangle.vertex[i]]));
    }
  }
}

/// A few triangles with the normals of a sphere: what is reflected below the facet is not lost.
void normalsOfASphere(Trial& t) {
  const RoughSphere sphere{6, 8};
  for (const float side : {1.0F, -1.0F}) {
    SceneBuilder builder;
    sphere.addTo(builder, mirror(Vec3f(1.0F)));
    builder.background(Vec3f(1.0F)).camera(lookAt({0.0, 0.4, 5.0}, Vec3d(0.0), 32.0));
    Scene scene = builder.build();
    makeRound(scene, side);
    const EstimatorSettings settings = withoutRoulette(misSampling());
    const Film film = t.render(scene, {.estimator = settings, .width = 64, .height = 64, .frames = 16}).film;
    t.expectConstant(film, Vec3d(1.0), 0,
                     side > 0 ? "a white mirror" : "a white mirror with its normals turned");
  }
}

/// Facets show where light grazes a round shape of few triangles: no fault, but the shading is that of the
/// facets.
void shadowTerminator(Trial& t) {
  const RoughSphere sphere{6, 8};
  for (const float side : {1.0F, -1.0F}) {
    SceneBuilder builder;
    sphere.addTo(builder, diffuse(Vec3f(0.8F)));
    builder.ceiling({0.0, 30.0, 0.0}, 3.0, emitter(Vec3f(50.0F)))
        .camera(lookAt({0.0, 0.4, 5.0}, Vec3d(0.0), 32.0));
    Scene scene = builder.build();
    makeRound(scene, side);
    const Film film =
        t.render(scene, {.estimator = misSampling(), .width = 32, .height = 32, .frames = 32}).film;
    bool sound = true;
    for (const PixelMoments& p : film.pixels)
      sound = sound && std::isfinite(p.mean.x) && p.mean.x >= 0.0 && p.mean.x < 50.0;
    t.expect(sound, "a pixel that is not finite, negative or brighter than the lamp");
    t.note(side > 0 ? "mean of a round shape" : "mean with its normals turned", estimateOf(film).mean.x);
  }
}

constexpr Case kRayCases[] = {
    {"o1-same-at-every-scale-and-place", "scaled by 1e-4 and 1e6 and moved by 1e5, a room is the same",
     sameAtEveryScale},
    {"o2-far-from-the-middle", "a room 100 sizes from the middle of its scene is the same", farFromTheMiddle},
    {"o3-lamp-close-to-a-floor", "a lamp 1e-5 of its size above a floor has its closed form", lampClose},
    {"o4-camera-in-a-corner", "no ray leaves a furnace through its corners", cameraInACorner},
    {"o5-shadow-terminator", "round normals on few facets give no fault under grazing light",
     shadowTerminator},
    {"o6-normals-against-the-surface", "a white mirror in white stays white, whatever its normals",
     normalsOfASphere},
    {"o9-camera-on-a-surface", "an eye 1e-5 above a surface sees it, one below does not", cameraOnASurface},
};

} // namespace

std::span<const Case> rayCases() { return kRayCases; }

} // namespace vkpt::selftest
