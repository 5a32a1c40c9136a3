#include "selftest/bsdf_directions.h"

#include "selftest/bsdf_probe.h"
#include "selftest/direction_grid.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vkpt {
namespace {

/// The same numbers on every machine, which std::uniform_real_distribution does not promise.
class RandomDirections {
public:
  explicit RandomDirections(std::uint32_t seed) : m_engine(seed) {}

  /// Uniform over the hemisphere about +z.
  Vec3d next() {
    const double cosTheta = unit();
    const double phi = 2.0 * std::numbers::pi * unit();
    const double sinTheta = std::sqrt(1.0 - cosTheta * cosTheta);
    return {sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta};
  }

private:
  /// In (0, 1).
  double unit() { return (static_cast<double>(m_engine()) + 0.5) / 4294967296.0; }

  std::mt19937 m_engine;
};

/// Of the samples, as in Nori: rounding may leave so many where the density is 0.
constexpr double kTolerableShare = 1e-5;

struct Stream {
  std::uint32_t seed;
  std::uint32_t number;
};

TestOutcome testFrom(const Vec3d& wo, const Material& bsdf, const BsdfProbe& probe, const NoriChi2Test& test,
                     const Stream& stream, double level) {
  const SampleDirection sample = [&](std::uint32_t index) -> std::optional<Vec3d> {
    const BsdfProbe::Sample taken = probe.sample(wo, stream.seed, stream.number, index);
    return taken.weight == Vec3d(0.0) ? std::nullopt : std::optional(taken.wi);
  };
  const DirectionDensity density = [&](const Vec3d& wi) { return probe.density(wo, wi); };
  const DirectionCounts counts = countDirections(DirectionGrid(test.resolution), sample, density,
                                                 static_cast<std::uint32_t>(test.sampleCount));
  const auto share = [&](double CellCount::*number) {
    return 1.0 - counts.cells.back().*number / test.sampleCount;
  };
  TestOutcome outcome;
  outcome.where = bsdf.where;
  outcome.what = fmt::format("{} from {:.3f},{:.3f},{:.3f}", bsdf.name, wo.x, wo.y, wo.z);
  outcome.figures = fmt::format("{:.6f} of {} samples scattered, integral of the density {:.6f}",
                                share(&CellCount::observed), test.sampleCount, share(&CellCount::expected));
  outcome.statistic = chiSquareTest(counts.cells, test.minExpFrequency);
  outcome.level = level;
  if (counts.impossible > kTolerableShare * test.sampleCount)
    outcome.statistic.why = fmt::format("{} samples where the density is not above 0", counts.impossible);
  return outcome;
}

bool transmits(const Material& bsdf) { return bsdf.bsdf == BsdfType::RoughDielectric; }

} // namespace

void checkDensities(const NoriChi2Test& test) {
  for (const Material& bsdf : test.bsdfs) {
    if (!BsdfProbe(bsdf).hasDensity()) {
      throw SceneError(bsdf.where,
                       fmt::format("{} has no density of directions to test: it is black, or scatters "
                                   "to single directions; test a rough one",
                                   bsdf.name));
    }
  }
}

void testBsdfDirections(const NoriChi2Test& test, std::uint32_t seed, const TellOutcome& tell) {
  const std::size_t tests = test.bsdfs.size() * static_cast<std::size_t>(test.testCount);
  const double level = sidakLevel(test.significanceLevel, tests);
  RandomDirections directions(seed);
  std::uint32_t stream = 0;
  for (const Material& bsdf : test.bsdfs) {
    const BsdfProbe probe(bsdf);
    for (int i = 0; i < test.testCount; ++i) {
      Vec3d wo = directions.next();
      if (transmits(bsdf) && i % 2 == 1)
        wo.z = -wo.z;
      tell(testFrom(wo, bsdf, probe, test, {seed, stream++}, level));
    }
  }
}

} // namespace vkpt
