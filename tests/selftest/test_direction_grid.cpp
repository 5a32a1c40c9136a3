// Counting directions, and integrating densities over the cells.

#include "selftest/direction_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace vkpt::test {
namespace {

constexpr double kPi = std::numbers::pi;

Vec3d direction(double cosTheta, double phi) {
  const double sinTheta = std::sqrt(1.0 - cosTheta * cosTheta);
  return {sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta};
}

TEST(DirectionGrid, CellsByCosineThenAzimuth) {
  const DirectionGrid grid(10);
  EXPECT_EQ(grid.size(), 200U);
  EXPECT_EQ(grid.cellOf(direction(-0.95, 0.1)), 0U);
  EXPECT_EQ(grid.cellOf(direction(-0.95, 0.1 - 0.2)), 19U) << "the azimuth is counted from 0 to a turn";
  EXPECT_EQ(grid.cellOf(direction(0.95, 0.1)), 180U);
  EXPECT_EQ(grid.cellOf(direction(0.05, kPi)), 110U);
  EXPECT_EQ(grid.cellOf({0.0, 0.0, 1.0}), 180U) << "the pole belongs to the last row";
  EXPECT_EQ(grid.cellOf({0.0, 0.0, -1.0}), 0U);
  EXPECT_LT(grid.cellOf({std::nan(""), std::nan(""), std::nan("")}), grid.size());
}

double sum(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0);
}

TEST(DirectionGrid, UniformDensity) {
  for (const double share : DirectionGrid(7).integrate([](const Vec3d&) { return 1.0 / (4.0 * kPi); }))
    EXPECT_NEAR(share, 1.0 / 98.0, 1e-12);
}

TEST(DirectionGrid, CosineInClosedForm) {
  const auto shares = DirectionGrid(10).integrate([](const Vec3d& w) { return std::max(w.z, 0.0) / kPi; });
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const double z0 = std::max(-1.0 + 0.2 * static_cast<double>(i / 20), 0.0);
    const double z1 = std::max(-1.0 + 0.2 * static_cast<double>(i / 20 + 1), 0.0);
    EXPECT_NEAR(shares[i], (z1 * z1 - z0 * z0) / 20.0, 1e-9);
  }
}

TEST(DirectionGrid, FindsANarrowPeak) {
  constexpr double kExponent = 3000.0; // 1/40 of a turn wide
  const Vec3d axis = direction(0.63, 1.234);
  const auto shares = DirectionGrid(10).integrate([&](const Vec3d& w) {
    return (kExponent + 1.0) / (2.0 * kPi) * std::pow(std::max(glm::dot(w, axis), 0.0), kExponent);
  });
  EXPECT_NEAR(sum(shares), 1.0, 1e-5);
}

TEST(DirectionGrid, EdgeThroughCells) {
  const Vec3d axis = direction(0.3, 0.4);
  const auto shares =
      DirectionGrid(5).integrate([&](const Vec3d& w) { return glm::dot(w, axis) > 0.0 ? 0.5 / kPi : 0.0; });
  EXPECT_NEAR(sum(shares), 1.0, 1e-4);
}

/// Directions in proportion to the cosine about +z; one in `givesUp` is not sampled, 0: all are.
class CosineSampler {
public:
  explicit CosineSampler(std::uint32_t givesUp = 0) : m_givesUp(givesUp) {}

  std::optional<Vec3d> operator()(std::uint32_t index) {
    const double u = unit();
    const double v = unit();
    if (m_givesUp > 0 && index % m_givesUp == 0)
      return std::nullopt;
    return direction(std::sqrt(u), 2.0 * kPi * v);
  }

private:
  double unit() { return (static_cast<double>(m_engine()) + 0.5) / 4294967296.0; }

  std::mt19937 m_engine{1};
  std::uint32_t m_givesUp;
};

double pValue(CosineSampler sampler, const DirectionDensity& density) {
  const DirectionCounts counts = countDirections(
      DirectionGrid(10), [&](std::uint32_t i) { return sampler(i); }, density, 100'000);
  return chiSquareTest(counts.cells, 5.0).p;
}

double cosineDensity(const Vec3d& w) { return std::max(w.z, 0.0) / kPi; }

TEST(DirectionCounts, AgreeWithTheRightDensity) {
  EXPECT_GT(pValue(CosineSampler(), cosineDensity), 1e-3);
  EXPECT_GT(pValue(CosineSampler(5), [](const Vec3d& w) { return 0.8 * cosineDensity(w); }), 1e-3);
}

TEST(DirectionCounts, RefuseWrongDensities) {
  EXPECT_LT(pValue(CosineSampler(), [](const Vec3d& w) { return w.z > 0.0 ? 0.5 / kPi : 0.0; }), 1e-9)
      << "uniform";
  EXPECT_LT(pValue(CosineSampler(), [](const Vec3d& w) { return 1.05 * cosineDensity(w); }), 1e-6)
      << "too large by 5 %";
  EXPECT_LT(pValue(CosineSampler(), [](const Vec3d& w) { return 0.98 * cosineDensity(w); }), 1e-9)
      << "too small by 2 %: nothing gave up";
  EXPECT_LT(pValue(CosineSampler(), [](const Vec3d& w) { return cosineDensity(w) * (1.0 + 0.1 * w.x); }),
            1e-9)
      << "lopsided";
  EXPECT_LT(pValue(CosineSampler(50), cosineDensity), 1e-9) << "samples that gave up";
}

TEST(DirectionCounts, CountWhatIsImpossible) {
  const auto front = [](const Vec3d& w) { return w.x > 0.0 ? 2.0 * cosineDensity(w) : 0.0; };
  CosineSampler sampler;
  const auto sample = [&](std::uint32_t i) { return sampler(i); };
  EXPECT_NEAR(countDirections(DirectionGrid(4), sample, front, 10'000).impossible, 5000.0, 300.0);
  EXPECT_EQ(countDirections(DirectionGrid(4), sample, cosineDensity, 10'000).impossible, 0U);
}

} // namespace
} // namespace vkpt::test
