// The samplers beside the BSDFs: triangles, the choice of a light, the environment, reconstruction filters.
#include "bsdf/cells.h"
#include "bsdf/chi_square.h"
#include "bsdf/oracle.h"
#include "bsdf/probe.h"
#include "device/light_tree.h"
#include "scenes/scene_builder.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace vkpt::test {
namespace {

constexpr std::uint32_t kLightDraws = 1U << 18U;
constexpr double kTests = 19; // chi-square tests in this file

void expectLikely(const ChiSquare& result, const std::string& what) {
  EXPECT_GT(result.probability, kFamilyAlpha / kTests) << what << ": " << result.figures();
}

EffectSet only(std::initializer_list<Effect> effects) {
  EffectSet set;
  for (const Effect e : effects)
    set.set(e);
  return set;
}

class Sampling : public RenderTest {};

/// (b1, b2) of a triangle to the unit square, area to area: the inverse of the square root warp.
TEST_F(Sampling, PointsOfATriangleAreUniform) {
  const Vec3d a(-1, 2, 3);
  const Vec3d b(2, 2.5, 3.5);
  const Vec3d c(-0.5, 2.2, 5);
  SceneBuilder builder;
  builder.triangle(a, b, c, emitter(Vec3f(1.0F)));
  Probe probe(builder.build(), only({Effect::LightSampling, Effect::AreaLights}));
  const Vec3d p(0.3, 0.0, 4.0);
  const Grid grid{16, 16};
  std::vector<double> observed(grid.size());
  const Vec3d ab = b - a;
  const Vec3d ac = c - a;
  const Vec3d normal = glm::cross(ab, ac);
  double solidAngle = 0.0;
  double squares = 0.0;
  const Vec3d origin(probe.constants().eye.x, probe.constants().eye.y, probe.constants().eye.z);
  const Scene scene = builder.build();
  for (const LightDraw& d : probe.sampleLight(Vec3f(p - scene.origin), kLightDraws, seed())) {
    const Vec3d at = Vec3d(d.end) + scene.origin - a;
    const double b1 = glm::dot(glm::cross(at, ac), normal) / glm::dot(normal, normal);
    const double b2 = glm::dot(glm::cross(ab, at), normal) / glm::dot(normal, normal);
    const double r = b1 + b2;
    observed[grid.cellOf({r * r, b2 / r})] += 1.0;
    ASSERT_GT(d.pdf_w, 0.0F);
    const double w = 1.0 / static_cast<double>(d.pdf_w);
    solidAngle += w / kLightDraws;
    squares += w * w / kLightDraws;
  }
  const std::vector<double> expected(grid.size(),
                                     static_cast<double>(kLightDraws) / static_cast<double>(grid.size()));
  expectLikely(chiSquare(observed, expected), "points");
  // The mean of 1 / pdf is the solid angle: van Oosterom and Strackee 1983.
  const Vec3d u = glm::normalize(a - p);
  const Vec3d v = glm::normalize(b - p);
  const Vec3d w = glm::normalize(c - p);
  const double exact = 2.0 * std::abs(std::atan2(glm::dot(u, glm::cross(v, w)),
                                                 1.0 + glm::dot(u, v) + glm::dot(v, w) + glm::dot(w, u)));
  const double error = std::sqrt((squares - solidAngle * solidAngle) / kLightDraws);
  EXPECT_NEAR(solidAngle, exact, 4.5 * error);
}

EnvironmentMap map(int width, int height) {
  EnvironmentMap m;
  m.width = width;
  m.height = height;
  for (int i = 0; i < width * height; ++i) // of very different brightness, and some black
    m.radiance.emplace_back(
        i % 7 == 3 ? 0.0F : 0.1F + static_cast<float>((i * 37) % 101) * (i % 11 == 0 ? 1.0F : 0.02F));
  return m;
}

/// Nine triangles and one of each other kind of light, below a ceiling.
Scene twelveLights() {
  SceneBuilder builder;
  builder.ceiling({12, 12, 0}, 20, diffuse(Vec3f(0.5F)));
  for (int i = 0; i < 9; ++i) {
    const double size = 0.2 + 0.3 * i;
    builder.triangle({3.0 * i, 0, 0}, {3.0 * i, 0, size}, {3.0 * i + 1, 0, 0},
                     emitter(Vec3f(static_cast<float>(1 + (i * 5) % 9))));
  }
  Scene scene = builder.build();
  scene.pointLights.push_back({{}, Vec3f(1, 2, 3), Vec3f(5.0F)});
  scene.directionalLights.push_back({{}, Vec3f(0, -1, 0), Vec3f(0.05F)});
  scene.environment = map(8, 4);
  return scene;
}

/// As LightDraw::kind has it.
int kindOf(const LightSource& light, const std::vector<std::uint32_t>& order) {
  switch (light.kind) {
  case LightSource::Kind::Triangle:
    return static_cast<int>(std::ranges::find(order, light.index) - order.begin());
  case LightSource::Kind::Environment:
    return -1;
  case LightSource::Kind::Directional:
    return -2;
  case LightSource::Kind::Point:
    break;
  }
  return -3;
}

/// How often each light of the table is drawn.
std::vector<double> countedLights(const LightTable& table, const PackedScene& packed,
                                  const std::vector<LightDraw>& draws) {
  std::map<int, std::size_t> index;
  for (std::size_t i = 0; i < table.lights.size(); ++i)
    index[kindOf(table.lights[i], packed.bvh.triangleOrder)] = i;
  EXPECT_EQ(index.size(), table.lights.size());
  std::vector<double> counted(table.lights.size());
  for (const LightDraw& d : draws)
    counted[index.at(static_cast<int>(d.kind))] += 1.0;
  return counted;
}

const EffectSet kAllLights = only({Effect::LightSampling, Effect::AreaLights, Effect::ManyLights,
                                   Effect::DeltaLights, Effect::Environment});

TEST_F(Sampling, LightsAreChosenInProportionToTheirPower) {
  const Scene scene = twelveLights();
  Probe probe(scene, kAllLights);
  const LightTable table = makeLightTable(scene, LightStrategy::Mis);
  std::vector<double> expected;
  for (const LightSource& light : table.lights)
    expected.push_back(light.probability * kLightDraws);
  const auto draws = probe.sampleLight(Vec3f(1, 3, 1), kLightDraws, seed());
  expectLikely(chiSquare(countedLights(table, probe.packed(), draws), expected), "lights");
}

struct Place {
  Vec3f p, n;
};

/// As often as weights count on.
void expectChosenByTheTree(const Scene& scene, std::span<const Place> places, bool belowTables,
                           std::uint32_t seed) {
  EffectSet effects = kAllLights;
  effects.set(Effect::LightTree);
  Probe probe(scene, effects);
  const Oracle oracle(probe.packed(), probe.constants(), effects);
  ASSERT_TRUE(probe.packed().lightChoice.byTables);
  ASSERT_EQ(probe.packed().lightChoice.belowTables, belowTables);
  const LightTable table = makeLightTable(scene, LightStrategy::Mis);
  const LightTree tree = makeLightTree(scene, table);
  for (const Place& place : places) {
    std::vector<double> expected;
    double sum = 0.0;
    for (std::uint32_t i = 0; i < table.lights.size(); ++i) {
      const std::uint32_t leaf = belowTables ? tree.leafOfLight[i] : i;
      const double probability = oracle.treeProbability(leaf, Vec3d(place.p), Vec3d(place.n));
      sum += probability;
      expected.push_back(probability * kLightDraws);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    const auto draws = probe.sampleLight(place.p, kLightDraws, seed, place.n);
    expectLikely(chiSquare(countedLights(table, probe.packed(), draws), expected), "lights by the tree");
  }
}

/// Seen from one side, from both, from among the lights; where the grid has tables, between its surfaces and
/// outside of it.
TEST_F(Sampling, LightsAreChosenByTheTreeAsItsProbabilitiesSay) {
  expectChosenByTheTree(twelveLights(),
                        std::array{Place{Vec3f(1, 3, 1), Vec3f(0, -1, 0)}, Place{Vec3f(1, 3, 1), Vec3f(0.0F)},
                                   Place{Vec3f(12, 0.01F, 0.1F), Vec3f(0, 1, 0)},
                                   Place{Vec3f(12, 0.01F, 0.1F), Vec3f(0.0F)},
                                   Place{Vec3f(12, -900, 0.1F), Vec3f(0, 1, 0)}},
                        false, seed());
}

/// More than a table has bins: the way back up ends at its nodes.
TEST_F(Sampling, ManyLightsAreChosenByTableAndTree) {
  SceneBuilder builder;
  for (int i = 0; i < 1500; ++i) {
    const double size = 0.2 + 0.1 * (i % 9);
    builder.triangle({2.0 * (i % 40), 0, 2.0 * (i / 40)}, {2.0 * (i % 40), 0, 2.0 * (i / 40) + size},
                     {2.0 * (i % 40) + 1, 0, 2.0 * (i / 40)},
                     emitter(Vec3f(static_cast<float>(1 + (i * 5) % 7))));
  }
  const Scene scene = builder.build();
  expectChosenByTheTree(scene,
                        std::array{Place{Vec3f(11.3F, 0.01F, 12.1F), Vec3f(0, 1, 0)},
                                   Place{Vec3f(11.3F, 30, 12.1F), Vec3f(0, -1, 0)}},
                        true, seed());
}

/// Four cells to a texel, equal in solid angle.
TEST_F(Sampling, DirectionsToTheEnvironmentAreInProportionToRadiance) {
  const int width = 16;
  const int height = 8;
  SceneBuilder builder;
  builder.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, diffuse(Vec3f(0.5F)));
  Scene scene = builder.build();
  scene.environment = map(width, height);
  Probe probe(scene, only({Effect::LightSampling, Effect::Environment}));
  const std::vector<double> angles = texelSolidAngles(width, height);
  double total = 0.0;
  for (int i = 0; i < width * height; ++i)
    total += static_cast<double>(scene.environment.radiance[static_cast<std::size_t>(i)].x) *
             angles[static_cast<std::size_t>(i / width)];
  std::vector<double> expected;
  for (int i = 0; i < width * height; ++i) {
    const double p = static_cast<double>(scene.environment.radiance[static_cast<std::size_t>(i)].x) *
                     angles[static_cast<std::size_t>(i / width)] / total;
    expected.insert(expected.end(), 4, 0.25 * p * kLightDraws);
  }
  std::vector<double> observed(expected.size());
  int elsewhere = 0;
  for (const EnvironmentDraw& d : probe.sampleEnvironment(kLightDraws, seed())) {
    const Vec3d wi = glm::normalize(Vec3d(d.wi));
    const double row = std::acos(wi.y) / std::numbers::pi * height;
    const double column = (std::atan2(wi.x, -wi.z) / (2.0 * std::numbers::pi) + 0.5) * width;
    const int r = std::min(static_cast<int>(row), height - 1);
    const int c = std::min(static_cast<int>(column), width - 1);
    const double upper = std::cos(std::numbers::pi * r / height);
    const double lower = std::cos(std::numbers::pi * (r + 1) / height);
    const int sub = ((upper - wi.y) / (upper - lower) < 0.5 ? 0 : 2) + (column - c < 0.5 ? 0 : 1);
    const std::size_t texel = static_cast<std::size_t>(r * width + c);
    observed[4 * texel + static_cast<std::size_t>(sub)] += 1.0;
    const double pdf = static_cast<double>(scene.environment.radiance[texel].x) / total;
    elsewhere += std::abs(static_cast<double>(d.pdf_w) - pdf) > 1e-6 * pdf ? 1 : 0;
    elsewhere += d.pdf_w != d.pdfAt ? 1 : 0;
  }
  // Rounding moves a draw over its texel's edge: a few ulp of a texel's breadth, on four edges, on both
  // counts.
  EXPECT_LE(elsewhere, 2 + static_cast<int>(kLightDraws * 16.0 * 8.0 * 0x1p-22));
  // The draws of a black texel are such; chi-square has no patience with any.
  double black = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] == 0.0)
      black += std::exchange(observed[i], 0.0);
  }
  EXPECT_LE(black, elsewhere);
  expectLikely(chiSquare(observed, expected), "directions");
}

double filterAt(const PixelFilter& f, double x) { // up to a factor
  const double r = std::abs(x);
  switch (f.shape) {
  case PixelFilter::Shape::Box:
    return r < f.radius ? 1.0 : 0.0;
  case PixelFilter::Shape::Tent:
    return std::max(0.0, f.radius - r);
  case PixelFilter::Shape::Gaussian: {
    const double k = -0.5 / (f.stddev * f.stddev);
    return std::max(0.0, std::exp(k * r * r) - std::exp(k * f.radius * f.radius));
  }
  case PixelFilter::Shape::Mitchell: { // Mitchell and Netravali 1988, eq. 8
    const double t = 2.0 * r / f.radius;
    const double b = f.b;
    const double c = f.c;
    if (t < 1.0)
      return (12 - 9 * b - 6 * c) * t * t * t + (-18 + 12 * b + 6 * c) * t * t + 6 - 2 * b;
    return t < 2.0
               ? (-b - 6 * c) * t * t * t + (6 * b + 30 * c) * t * t + (-12 * b - 48 * c) * t + 8 * b + 24 * c
               : 0.0;
  }
  }
  return 0.0;
}

class FilterSampling : public RenderTest, public testing::WithParamInterface<PixelFilter> {};

/// Draws, weighted as the sampler says, add up to the filter in every cell; and they are about where |filter|
/// is.
TEST_P(FilterSampling, WeightedDrawsAreTheFilter) {
  SceneBuilder builder;
  builder.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, diffuse(Vec3f(0.5F)));
  Scene scene = builder.build();
  scene.filter = GetParam();
  Probe probe(scene, only({Effect::PixelFilter}));
  const Grid grid{40, 1};
  const double r = scene.filter.radius;
  const std::vector<Vec2d> cells = integrals(
      grid,
      [&](double u, double) {
        const double value = filterAt(scene.filter, (2.0 * u - 1.0) * r);
        return Vec2d(value, std::abs(value));
      },
      1e-9);
  Vec2d total(0.0);
  for (const Vec2d& c : cells)
    total += c;
  std::vector<double> sum(grid.size());
  std::vector<double> squares(grid.size());
  std::vector<double> count(grid.size());
  for (const FilterDraw& d : probe.sampleFilter(kLightDraws, seed())) {
    ASSERT_LE(std::abs(d.offset), static_cast<float>(r));
    const std::size_t cell = grid.cellOf({0.5 * (static_cast<double>(d.offset) / r + 1.0), 0.5});
    const double w = static_cast<double>(d.weight);
    sum[cell] += w / kLightDraws;
    squares[cell] += w * w / kLightDraws;
    count[cell] += 1.0;
  }
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double exact = cells[i].x / total.x;
    const double error = std::sqrt((squares[i] - sum[i] * sum[i]) / kLightDraws);
    EXPECT_NEAR(sum[i], exact, sidakBound(200) * error + 1e-5 * std::abs(exact)) << "cell " << i;
    // Where |filter| is; within a bin, of which there are kFilterBins, by a trapezium.
    const double share = cells[i].y / total.y;
    const double bin = 0.1 / shared::kFilterBins;
    EXPECT_NEAR(count[i] / kLightDraws, share, 0.1 * share + bin + 5.0 * std::sqrt(share / kLightDraws))
        << "cell " << i;
  }
}

PixelFilter filterOf(PixelFilter::Shape shape, double radius) {
  PixelFilter f;
  f.shape = shape;
  f.radius = radius;
  return f;
}

std::string nameOf(const testing::TestParamInfo<PixelFilter>& test) {
  constexpr const char* kNames[] = {"Box", "Tent", "Gaussian", "Mitchell"};
  return kNames[static_cast<std::size_t>(test.param.shape)];
}

INSTANTIATE_TEST_SUITE_P(Of, FilterSampling,
                         testing::Values(filterOf(PixelFilter::Shape::Box, 0.7),
                                         filterOf(PixelFilter::Shape::Tent, 1.0),
                                         filterOf(PixelFilter::Shape::Gaussian, 2.0),
                                         filterOf(PixelFilter::Shape::Mitchell, 2.0)),
                         nameOf);

} // namespace
} // namespace vkpt::test
