// Lights chosen by the tree and the tables of its nodes: the image stays what it is, and noise goes where
// lights are far apart.
#include "scenes/scene_extras.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt::test {
namespace {

EstimatorSettings byTree(EstimatorSettings settings = misSampling()) {
  settings.lightSelection = LightSelection::Tree;
  return settings;
}

/// A room with lamps of very different size and brightness that look all ways, and a block between them.
/// scale: of the lamps' size.
Scene lampsAllAround(int count, double scale) {
  SceneBuilder builder;
  builder.box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse({0.6F, 0.5F, 0.4F}));
  builder.box({-0.3, -1.0, -0.4}, {0.2, -0.2, 0.1}, Facing::Outward, phong(Vec3f(0.3F), Vec3f(0.4F), 30.0F));
  for (int i = 0; i < count; ++i) {
    const double turn = 2.4 * i; // golden angle
    const double height = -0.7 + 1.5 * (i + 0.5) / count;
    const Vec3d at(0.6 * std::cos(turn), height, 0.6 * std::sin(turn));
    const double size = scale * (0.03 + 0.02 * (i % 5));
    const Vec3d along(std::cos(5.0 * i), std::sin(5.0 * i), 0.3);
    const Vec3d across(0.2, std::cos(3.0 * i), std::sin(3.0 * i));
    builder.triangle(at, at + size * glm::normalize(along), at + size * glm::normalize(across),
                     emitter(Vec3f(static_cast<float>(2 + (i * 7) % 11))));
  }
  builder.camera(lookAt({0.0, 0.3, 0.95}, {0.0, -0.3, 0.0}, 100.0));
  return builder.build();
}

/// By light sampling alone and weighted, against the choice by power.
void expectSameByTree(Trial& t, const Scene& scene) {
  const auto with = [&](EstimatorSettings e) {
    e.pathKinds = kAllPathKinds & ~1U; // without the lamps themselves, whose edges are all noise
    return t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = 192}).film;
  };
  const Film power = with(misSampling());
  for (const auto& [light, name] : {std::pair(LightStrategy::Nee, "nee"), {LightStrategy::Mis, "mis"}}) {
    const Film tree = with(byTree(findingLightBy(light)));
    t.expectEqualMeans(tree, power, 0.03, name);
    for (int i = 0; i < 4; ++i)
      t.expectEqualMeans(columns(tree, 8 * i, 8), columns(power, 8 * i, 8), 0.06,
                         fmt::format("{}, columns from {}", name, 8 * i));
  }
}

void lampsByTree(Trial& t) { expectSameByTree(t, lampsAllAround(24, 1.0)); }

/// More lamps than a table of the grid has bins: below these the tree decides.
void lampsBelowTables(Trial& t) { expectSameByTree(t, lampsAllAround(1200, 0.25)); }

/// Where hits decide: a bright floor between glowing walls, which BSDF sampling finds as well as light
/// sampling does, in the proportions of the tree.
void glowByTree(Trial& t) {
  const Vec3f albedo(0.5F, 0.4F, 0.3F);
  const Vec3f emission(3.0F, 2.0F, 1.0F);
  const Scene scene = SceneBuilder()
                          .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse(albedo, emission))
                          .camera(lookAt({0.3, 0.6, 0.8}, {0.0, -0.9, 0.0}, 80.0))
                          .build();
  const Film film = t.render(scene, {.estimator = byTree(), .width = 32, .height = 32, .frames = 512}).film;
  t.expectMean(film, Vec3d(emission) / (Vec3d(1.0) - Vec3d(albedo)), 0.02);
}

/// Triangles, a point light, a directional one and an environment in one tree, seen from metal, glass, rough
/// surfaces and facets.
void everythingByTree(Trial& t) {
  const Scene scene = everything();
  const auto with = [&](const EstimatorSettings& e) {
    return t.render(scene, {.estimator = e, .width = 32, .height = 32, .frames = 192}).film;
  };
  t.expectEqualMeans(with(byTree()), with(misSampling()), 0.03, "everything");
}

/// What a path must remember to weigh the emission it meets.
void carriedByTree(Trial& t) {
  t.expectSameWhenCarried(glowingRoom(), {.estimator = byTree(), .width = 8, .height = 8, .frames = 16});
}

/// A lamp close by and fifteen as bright in a row that leads away: most of their light goes elsewhere.
void treeFindsTheNearLamp(Trial& t) {
  SceneBuilder builder;
  builder.floor({0.0, 0.0, 0.0}, 0.5, diffuse(Vec3f(0.8F)));
  for (int i = 0; i < 16; ++i)
    builder.ceiling({4.0 * i, 1.0, 0.0}, 0.05, emitter(Vec3f(1.0F)));
  builder.camera(lookAt({0.0, 0.8, 0.0}, Vec3d(0.0), 40.0, {0.0, 0.0, 1.0}));
  const auto varianceOf = [&](const EstimatorSettings& e) {
    const RenderSetup setup{.estimator = withBounces(e, 1), .width = 16, .height = 16, .frames = 256};
    return sampleVariance(t.render(builder.build(), setup).film).x;
  };
  const double power = varianceOf(misSampling());
  const double tree = varianceOf(byTree());
  t.expect(tree < 0.02 * power, fmt::format("variances: by power {:.3g}, by the tree {:.3g}", power, tree));
}

constexpr Check kLightTreeChecks[] = {
    {"carriedByTree", carriedByTree},
    {"treeFindsTheNearLamp", treeFindsTheNearLamp},
    {"glowByTree", glowByTree},
    {"lampsByTree", lampsByTree},
    {"lampsBelowTables", lampsBelowTables},
    {"everythingByTree", everythingByTree},
};

} // namespace

std::span<const Check> lightTreeChecks() { return kLightTreeChecks; }

} // namespace vkpt::test
