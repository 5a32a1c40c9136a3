// The double-precision oracle: the same paths, with the same random numbers, on the device in float and on
// the host in double, path by path.
#include "scene/load.h"
#include "selftest/case.h"
#include "selftest/record_paths.h"
#include "selftest/scene_builder.h"

#include <boost/math/distributions/poisson.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vkpt::selftest {
namespace {

constexpr int kImageEdge = 64;
constexpr std::uint32_t kPathsOfPixel = 4; // of each pixel

/// What a scene may do. Paths part where rounding decides a comparison: at a silhouette, at a lobe's share,
/// at roulette; independently of each other, so their number is Poisson's. Curved glass and narrow lobes
/// magnify what rounding has done at every bounce.
struct Limits {
  double parted; ///< paths that part, of a million
  double middle; ///< relative difference of half of those that don't
  double most;   ///< and of 99 of 100
};

struct Comparison {
  std::array<std::size_t, 5> partings{}; ///< by kind
  std::vector<double> relative;          ///< differences of paths that agree, over their radiance
  double sum = 0.0;                      ///< of all signed differences
  double squares = 0.0;
  double radiance = 0.0;
  double scale = 0.0; ///< the scene's mean radiance, roughly
  std::size_t paths = 0;
  std::size_t unfinished = 0;
};

/// Of the mean radiance: less than that is noise of the scene, however large beside itself.
constexpr double kLeastShare = 1e-4;

double brightness(const Vec3d& L) { return (L.x + L.y + L.z) / 3.0; }

void compareSample(const Trial& t, const OracleScene& scene, std::uint32_t sample, Comparison& c) {
  const std::vector<shared::PathRecord> records = recordPaths(t, scene, sample);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const shared::PathRecord& device = records[i];
    if (device.unfinished != 0) {
      ++c.unfinished;
      continue;
    }
    const auto x = static_cast<int>(i) % scene.settings.width;
    const auto y = static_cast<int>(i) / scene.settings.width;
    const Replay host = replay64(scene.packed, scene.scene, scene.effects, scene.settings, x, y, sample);
    const double exact = brightness(host.value);
    const double difference = brightness({device.value.x, device.value.y, device.value.z}) - exact;
    const Parting parting = partingOf(device, host, kLeastShare * c.scale);
    ++c.partings.at(static_cast<std::size_t>(parting));
    if (parting == Parting::None)
      c.relative.push_back(std::abs(difference) / (std::abs(exact) + kLeastShare * c.scale));
    ++c.paths;
    c.sum += difference;
    c.squares += difference * difference;
    c.radiance += exact;
  }
}

double quantile(std::vector<double>& x, double share) {
  if (x.empty())
    return 0.0;
  const auto at = x.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(x.size() - 1));
  std::ranges::nth_element(x, at, [](double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; });
  return *at;
}

void judge(Trial& t, Comparison& c, const Limits& limits) {
  constexpr double kChance = 1e-6; // of a scene within its budget to exceed it
  constexpr double kRounding = 1e-6;
  const auto n = static_cast<double>(c.paths);
  const std::size_t parted = c.paths - c.partings[0];
  const boost::math::poisson expected(std::max(limits.parted * 1e-6 * n, 1e-9));
  t.atMost(
      "paths that part", static_cast<double>(parted),
      boost::math::quantile(boost::math::complement(expected, kChance)),
      fmt::format("of {}: {} met another triangle, {} took another lobe, {} by roulette, {} by shadow rays",
                  c.paths, c.partings[1], c.partings[2], c.partings[3], c.partings[4]));
  t.atMost("half of the others differ by", quantile(c.relative, 0.5), limits.middle);
  t.atMost("99 of 100 differ by", quantile(c.relative, 0.99), limits.most);
  // Signed, over all paths: parted ones have independent values, whose differences average out.
  const double mean = c.sum / n;
  const double error = std::sqrt(std::max(c.squares / n - mean * mean, 0.0) / n);
  t.atMost("signed mean difference over its bound",
           std::abs(mean) / (4.5 * error + kRounding * c.radiance / n), 1.0,
           fmt::format("{:.3g} +- {:.2g} of {:.4g}", mean, error, c.radiance / n));
  t.atMost("paths given up", static_cast<double>(c.unfinished), 1e-3 * n);
}

void compareWithOracle(Trial& t, const Scene& scene, const Limits& limits) {
  const OracleScene s = oracleScene(scene, misSampling(), kImageEdge, kImageEdge, t.seed("oracle"));
  Comparison c;
  constexpr int kStep = 7; // pixels
  for (int i = 0; i < kImageEdge * kImageEdge; i += kStep)
    c.scale += brightness(replay64(s.packed, s.scene, s.effects, s.settings, i % kImageEdge, i / kImageEdge,
                                   kPathsOfPixel)
                              .value) *
               (double{kStep} / (kImageEdge * kImageEdge));
  for (std::uint32_t sample = 0; sample < kPathsOfPixel; ++sample)
    compareSample(t, s, sample, c);
  judge(t, c, limits);
}

void oracleBlocks(Trial& t) {
  SceneReport report;
  compareWithOracle(t, loadScene(std::vector<fs::path>{"cornell"}, report), {100.0, 2e-6, 3e-4});
}

void oracleSpheres(Trial& t) {
  SceneReport report;
  compareWithOracle(t, loadScene(std::vector<fs::path>{"cornell-spheres"}, report), {600.0, 2e-6, 1e-3});
}

/// Phong, Nori's microfacets and rough metals and glass, in a lit box.
void oracleGlossy(Trial& t) {
  const Vec3f eta(0.2F, 0.9F, 1.1F);
  const Vec3f k(3.9F, 2.5F, 2.2F);
  const Scene scene =
      SceneBuilder()
          .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse({0.6F, 0.5F, 0.4F}))
          .ceiling({0.0, 0.95, 0.0}, 0.4, emitter({6.0F, 5.0F, 4.0F}))
          .floor({0.0, -0.9, 0.0}, 0.9, phong(Vec3f(0.2F), Vec3f(0.6F), 200.0F))
          .box({-0.8, -0.8, -0.8}, {-0.3, 0.1, -0.4}, Facing::Outward,
               microfacet({0.2F, 0.3F, 0.5F}, 0.1F, 1.5F))
          .box({-0.2, -0.8, -0.8}, {0.3, -0.2, -0.3}, Facing::Outward, roughMetal(eta, k, 0.05F))
          .box({0.4, -0.8, -0.6}, {0.8, 0.2, -0.2}, Facing::Outward,
               roughMetal(eta, k, 0.3F, MicrofacetDistribution::Beckmann))
          .box({-0.3, -0.8, 0.1}, {0.2, -0.3, 0.5}, Facing::Outward, roughGlass(1.5F, 0.2F))
          .camera(lookAt({0.0, 0.2, 0.95}, {0.0, -0.3, -0.4}, 80.0))
          .build();
  compareWithOracle(t, scene, {100.0, 3e-6, 3e-4});
}

/// Smooth glass that absorbs, one block in another, and a mirror.
void oracleGlass(Trial& t) {
  Material tinted = glass(1.5F);
  tinted.absorption = {0.2F, 1.0F, 2.0F};
  const Scene scene =
      SceneBuilder()
          .box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, Facing::Inward, diffuse({0.7F, 0.7F, 0.6F}))
          .ceiling({0.0, 0.95, 0.0}, 0.4, emitter({6.0F, 5.0F, 4.0F}))
          .box({-0.7, -0.9, -0.6}, {0.2, 0.1, 0.2}, Facing::Outward, tinted)
          .box({-0.5, -0.7, -0.4}, {-0.1, -0.2, 0.0}, Facing::Outward, glass(1.2F))
          .quad({0.4, -0.9, -0.7}, {0.9, -0.9, -0.2}, {0.9, 0.5, -0.2}, {0.4, 0.5, -0.7},
                mirror({0.9F, 0.8F, 0.7F}))
          .camera(lookAt({0.3, 0.2, 0.95}, {-0.1, -0.4, -0.3}, 80.0))
          .build();
  compareWithOracle(t, scene, {200.0, 4e-6, 3e-4});
}

constexpr Case kOracleCases[] = {
    {"oracle-blocks", "the box with the blocks: the device's paths in float are the host's in double",
     oracleBlocks},
    {"oracle-spheres", "the same with a silver and a glass sphere", oracleSpheres},
    {"oracle-glossy", "the same for Phong, microfacets, rough metal and rough glass", oracleGlossy},
    {"oracle-glass", "the same for glass in absorbing glass, and a mirror", oracleGlass},
};

} // namespace

std::span<const Case> oracleCases() { return kOracleCases; }

} // namespace vkpt::selftest
