// Paths from the lights, joined to the eye, and several paths behind specular surfaces: the image stays what
// it is.
#include "scene/smooth_normals.h"
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::test {
namespace {

EstimatorSettings fromLights(EstimatorSettings settings = misSampling()) {
  settings.lightTracing = LightTracing::On;
  return settings;
}

EstimatorSettings repeated(std::uint32_t paths, EstimatorSettings settings = misSampling()) {
  settings.specularSamples = paths;
  return settings;
}

/// Eight triangles.
SceneBuilder& octahedron(SceneBuilder& builder, const Vec3d& c, double r, const Material& material) {
  for (int i = 0; i < 8; ++i) {
    const Vec3d x = c + Vec3d((i & 1) != 0 ? r : -r, 0.0, 0.0);
    const Vec3d y = c + Vec3d(0.0, (i & 2) != 0 ? r : -r, 0.0);
    const Vec3d z = c + Vec3d(0.0, 0.0, (i & 4) != 0 ? r : -r);
    const bool even = ((i & 1) + ((i >> 1) & 1) + ((i >> 2) & 1)) % 2 == 1;
    builder.triangle(x, even ? y : z, even ? z : y, material);
  }
  return builder;
}

/// Shading normals for the octahedra of a scene: as far from the triangles' as they get.
Scene smoothed(Scene scene) {
  std::vector<Triangle> round;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const BsdfType type = scene.materials[scene.triangles[i].material].bsdf;
    if (type == BsdfType::Dielectric || type == BsdfType::Mirror) {
      round.push_back(scene.triangles[i]);
      which.push_back(i);
    }
  }
  // One position for all corners that lie in one place.
  std::vector<Vec3d> positions;
  for (Triangle& t : round)
    for (std::uint32_t& v : t.vertex) {
      const Vec3d p = scene.positions[v];
      const auto found = std::ranges::find(positions, p);
      v = static_cast<std::uint32_t>(found - positions.begin());
      if (found == positions.end())
        positions.push_back(p);
    }
  std::size_t count = 0;
  const std::vector<Vec3d> normals = makeSmoothNormals(positions, round, count);
  scene.normals.assign(normals.begin(), normals.end());
  for (std::size_t i = 0; i < round.size(); ++i)
    scene.triangles[which[i]].normal = round[i].normal;
  return scene;
}

/// A room with a lamp and solids of glass and mirror, seen by a wide camera.
Scene causticRoom() {
  SceneBuilder builder;
  builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse({0.7F, 0.5F, 0.3F}));
  builder.ceiling({0.1, 0.98, -0.1}, 0.6, emitter({4.0F, 3.0F, 2.0F}));
  octahedron(builder, {-0.35, -0.3, -0.2}, 0.5, glass(1.5F));
  octahedron(builder, {0.5, 0.1, 0.1}, 0.35, mirror({0.9F, 0.8F, 0.7F}));
  builder.camera(lookAt({0.0, 0.2, 0.95}, {0.0, -0.1, 0.0}, 110.0));
  return builder.build();
}

/// Everything emits and nothing but the walls absorbs: Le / (1 - albedo) wherever the camera looks, by way of
/// mirror and glass as well.
void furnaceFromLights(Trial& t) {
  const Vec3f albedo(0.5F, 0.4F, 0.3F);
  const Vec3f emission(3.0F, 2.0F, 1.0F);
  const Scene scene = furnaceWithSolids(albedo, emission, lookAt({0.0, 0.3, 0.9}, {0.0, -0.2, 0.0}, 80.0));
  const Film film =
      t.render(scene, {.estimator = fromLights(), .width = 32, .height = 32, .frames = 128}).film;
  t.expectMean(film, Vec3d(emission) / (Vec3d(1.0) - Vec3d(albedo)), 0.02);
}

/// Flat and with shading normals that have little to do with the triangles': what the eye's paths find by
/// themselves.
void expectLightsCaustics(Trial& t, const Scene& scene) {
  const auto with = [&](const EstimatorSettings& e, std::uint64_t frames) {
    return t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = frames}).film;
  };
  const Film lights = with(fromLights(), 256);
  const Film eye = with(misSampling(), 512);
  t.expectEqualMeans(lights, eye, 0.02, "the image");
  // By place: the columns of a wide image.
  for (int i = 0; i < 4; ++i)
    t.expectEqualMeans(columns(lights, 8 * i, 8), columns(eye, 8 * i, 8), 0.05,
                       fmt::format("columns from {}", 8 * i));
}

void causticsFromLights(Trial& t) { expectLightsCaustics(t, causticRoom()); }
void smoothCausticsFromLights(Trial& t) { expectLightsCaustics(t, smoothed(causticRoom())); }

/// A mirror whose shading normals all lean the same way sends a lamp's light to a wall. The mirror's cosines
/// towards the lamp and towards the wall, of which flux knows and the shading normals don't, differ
/// everywhere.
void leaningMirror(Trial& t) {
  SceneBuilder builder;
  builder.ceiling({-0.5, 2.0, 0.0}, 0.7, emitter(Vec3f(1.0F)));
  builder.quad({2.0, 0.0, 1.0}, {2.0, 0.0, -1.0}, {2.0, 2.0, -1.0}, {2.0, 2.0, 1.0}, diffuse(Vec3f(0.8F)));
  builder.floor({0.0, 0.0, 0.0}, 1.0, mirror(Vec3f(0.9F)));
  builder.camera(lookAt({1.0, 1.0, 0.0}, {2.0, 1.0, 0.0}, 90.0));
  Scene scene = builder.build();
  const double lean = 0.45;
  scene.normals = {Vec3f(Vec3d(std::sin(lean), std::cos(lean), 0.0))};
  for (std::size_t i = scene.triangles.size() - 2; i < scene.triangles.size(); ++i)
    scene.triangles[i].normal = {0, 0, 0};
  const auto with = [&](const EstimatorSettings& e) {
    return t.render(scene, {.estimator = e, .width = 16, .height = 16, .frames = 4096}).film;
  };
  EstimatorSettings caustics = misSampling();
  caustics.pathKinds = 1U << static_cast<std::uint32_t>(PathKind::Caustic);
  t.expectEqualMeans(with(fromLights(caustics)), with(caustics), 0.05, "on the wall");
}

/// The camera and what it sees lie in glass, the lamp outside: flux and radiance differ by the square of the
/// index.
void lightIntoGlass(Trial& t) {
  SceneBuilder builder;
  builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Outward, glass(1.5F));
  builder.floor({0.0, -0.5, 0.0}, 0.8, diffuse(Vec3f(0.8F)));
  builder.ceiling({0.0, 1.5, 0.0}, 0.3, emitter(Vec3f(1.0F)));
  builder.camera(lookAt({0.0, 0.5, 0.7}, {0.0, -0.5, 0.0}, 80.0));
  const Scene scene = builder.build();
  const auto with = [&](const EstimatorSettings& e) {
    return t.render(scene, {.estimator = e, .width = 16, .height = 16, .frames = 2048}).film;
  };
  t.expectEqualMeans(with(fromLights()), with(misSampling()), 0.03, "in glass");
}

/// Kinds, and a bounce limit, mean the same to both.
void limitedFromLights(Trial& t) {
  const Scene scene = causticRoom();
  const auto kind = [](PathKind k) { return 1U << static_cast<std::uint32_t>(k); };
  struct Limit {
    const char* what;
    std::uint32_t bounces;
    std::uint32_t kinds;
  };
  for (const Limit& limit : {Limit{"two bounces", 2, kAllPathKinds}, Limit{"four bounces", 4, kAllPathKinds},
                             Limit{"primary caustics", kUnlimitedBounces, kind(PathKind::Caustic)},
                             Limit{"other caustics", kUnlimitedBounces, kind(PathKind::IndirectCaustic)}}) {
    const auto with = [&](EstimatorSettings e, std::uint64_t frames) {
      e.maxBounces = limit.bounces;
      e.pathKinds = limit.kinds;
      return t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = frames}).film;
    };
    t.expectEqualMeans(with(fromLights(), 256), with(misSampling(), 768), 0.1, limit.what);
  }
}

/// Every other kind of surface and light beside them.
void varietyFromLights(Trial& t) {
  Scene scene = variety();
  for (Material& m : scene.materials)
    m.absorption = Vec3f(0.0F); // they can't go together
  const auto with = [&](const EstimatorSettings& e) {
    return t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = 256}).film;
  };
  t.expectEqualMeans(with(repeated(3, fromLights())), with(misSampling()), 0.03, "with light paths");
  EstimatorSettings nee = fromLights();
  nee.light = LightStrategy::Nee;
  nee.lightSamples = 3;
  t.expectEqualMeans(with(nee), with(misSampling()), 0.03, "by light sampling alone");
}

void carriedFromLights(Trial& t) {
  t.expectSameWhenCarried(smoothed(causticRoom()),
                          {.estimator = repeated(3, fromLights()), .width = 24, .height = 24, .frames = 16});
}

/// A slab reflects a third of the light, towards red, the rest goes on to green. The first surface's share is
/// the number of paths that go there, behind it chance decides: once a path.
void repeatsAreAllotted(Trial& t) {
  SceneBuilder builder;
  const auto plate = [&](double z, double h, bool up, const Material& m) {
    if (up)
      builder.quad({-h, -h, z}, {h, -h, z}, {h, h, z}, {-h, h, z}, m);
    else
      builder.quad({-h, -h, z}, {-h, h, z}, {h, h, z}, {h, -h, z}, m);
  };
  constexpr double kAngle = 1.25;
  plate(0.0, 80.0, true, glass(1.5F));
  plate(-0.2, 80.0, false, glass(1.5F));
  plate(9.0, 1000.0, false, emitter({1.0F, 0.0F, 0.0F}));
  plate(-9.0, 1000.0, true, emitter({0.0F, 1.0F, 0.0F}));
  builder.camera(lookAt({4.0 * std::sin(kAngle), 0.0, 4.0 * std::cos(kAngle)}, Vec3d(0.0), kPointFov));
  const double r = exactFresnelDielectric(std::cos(kAngle), 1.5);
  const Vec3d expected(2.0 * r / (1.0 + r), (1.0 - r) / (1.0 + r), 0.0);
  const double within = r / ((1.0 + r) * (1.0 + r)); // variance of the choice of a path inside the slab
  for (const std::uint32_t paths : {1U, 2U, 4U, 16U}) {
    const double reflected = std::max(1.0, std::round(paths * r));
    const double variance =
        paths == 1 ? expected.x * expected.y : (1.0 - r) * (1.0 - r) * within / (paths - reflected);
    const Film film =
        t.render(builder.build(), {.estimator = repeated(paths), .width = 64, .height = 64, .frames = 32})
            .film;
    t.expectMean(film, expected, 0.05, fmt::format("{} paths", paths));
    t.expect(std::abs(sampleVariance(film).x / variance - 1.0) < 0.03,
             fmt::format("{} paths: variance over the expected one {:.3f}", paths,
                         sampleVariance(film).x / variance));
  }
}

constexpr Check kLightTracingChecks[] = {
    {"repeatsAreAllotted", repeatsAreAllotted},
    {"carriedFromLights", carriedFromLights},
    {"leaningMirror", leaningMirror},
    {"lightIntoGlass", lightIntoGlass},
    {"furnaceFromLights", furnaceFromLights},
    {"causticsFromLights", causticsFromLights},
    {"smoothCausticsFromLights", smoothCausticsFromLights},
    {"varietyFromLights", varietyFromLights},
    {"limitedFromLights", limitedFromLights},
};

} // namespace

std::span<const Check> lightTracingChecks() { return kLightTracingChecks; }

} // namespace vkpt::test
