// The table of guided directions: what is drawn from it is what it says, and it knows the places it has
// learned of.
#include "device/guide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace vkpt::test {
namespace {

using namespace shared;

Photon photonAt(const Vec3f& p, std::uint32_t bin, float power = 1.0F) { return {p, bin, power}; }

/// Where the histogram of the cube about p begins.
std::uint32_t startAt(const Guide& guide, const Vec3f& p) {
  const Vec3f q = (p - guide.grid.lower) * guide.grid.cubesPerMetre;
  const auto cube = [&](int axis) { return static_cast<std::uint32_t>(q[axis]); };
  return guide.numbers.at(guideCube(cube(0), cube(1), cube(2), guide.grid.edge));
}

std::uint32_t shareOf(const Guide& guide, std::uint32_t start, std::uint32_t bin) {
  return guide.numbers.at(start + bin) & 65535U;
}

/// Every draw that there is, by the bin that it ends with.
std::vector<std::uint32_t> draws(const Guide& guide, std::uint32_t start) {
  std::vector<std::uint32_t> count(kGuideBins);
  for (std::uint32_t row = 0; row < kGuideBins; ++row) {
    const std::uint32_t own = guide.numbers.at(start + row);
    const std::uint32_t alias = own >> 24U;
    for (std::uint32_t u = 0; u < kAliasUnits / kGuideBins; ++u)
      ++count[u < ((own >> 16U) & 255U) ? row : alias];
  }
  return count;
}

void expectDrawnAsItSays(const Guide& guide, std::uint32_t start) {
  const std::vector<std::uint32_t> count = draws(guide, start);
  for (std::uint32_t bin = 0; bin < kGuideBins; ++bin)
    ASSERT_EQ(count[bin], shareOf(guide, start, bin)) << bin;
}

TEST(Guide, KnowsNothingWithoutPhotons) {
  const Guide guide = makeGuide({});
  EXPECT_EQ(guide.grid.edge, 0U);
  EXPECT_EQ(guide.numbers.size(), 4U) << "a dummy";
}

TEST(Guide, DrawsTheSharesThatItTells) {
  std::mt19937 engine(0x6D1DE5U);
  std::uniform_int_distribution<std::uint32_t> bin(0, kGuideBins - 1);
  std::exponential_distribution<float> power(1.0F);
  for (const int photons : {1, 2, 3, 17, 256, 5000}) {
    std::vector<Photon> found;
    std::vector<double> weight(kGuideBins);
    double sum = 0.0;
    for (int i = 0; i < photons; ++i) {
      found.push_back(photonAt(Vec3f(1.0F, 2.0F, 3.0F), bin(engine), power(engine)));
      weight[found.back().bin] += static_cast<double>(found.back().power);
      sum += static_cast<double>(found.back().power);
    }
    const Guide guide = makeGuide(found);
    const std::uint32_t start = startAt(guide, found.front().p);
    ASSERT_NE(start, kNoGuide);
    expectDrawnAsItSays(guide, start);
    for (std::uint32_t i = 0; i < kGuideBins; ++i)
      ASSERT_NEAR(shareOf(guide, start, i), weight[i] / sum * kAliasUnits, 1.0) << i << " of " << photons;
  }
}

/// A share of all of it would not fit into 16 bits: two bins of very unlike light, and one alone.
TEST(Guide, ASingleBinKeepsOneUnitForAnother) {
  const std::vector<Photon> found{photonAt(Vec3f(0.0F), 7), photonAt(Vec3f(0.0F), 9, 1e-12F)};
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}}) {
    const Guide guide = makeGuide(std::span(found).first(count));
    const std::uint32_t start = startAt(guide, Vec3f(0.0F));
    EXPECT_EQ(shareOf(guide, start, 7), kAliasUnits - 1);
    expectDrawnAsItSays(guide, start);
  }
}

/// Many photons in one corner, whose directions differ from one cube of the finest grid to the next, and one
/// far away.
TEST(Guide, TellsPlacesApartWhereItHasSeenEnough) {
  std::vector<Photon> found{photonAt(Vec3f(64.0F), 200)};
  for (int i = 0; i < 400; ++i) {
    found.push_back(photonAt(Vec3f(0.5F, 0.5F, 0.5F), 10));
    found.push_back(photonAt(Vec3f(4.5F, 0.5F, 0.5F), 11));
  }
  const Guide guide = makeGuide(found);
  const auto share = [&](const Vec3f& p, std::uint32_t bin) {
    return shareOf(guide, startAt(guide, p), bin);
  };
  EXPECT_EQ(share(Vec3f(0.5F, 0.5F, 0.5F), 10), kAliasUnits - 1);
  EXPECT_EQ(share(Vec3f(4.5F, 0.5F, 0.5F), 11), kAliasUnits - 1);
  EXPECT_EQ(share(Vec3f(64.0F), 200), kAliasUnits - 1) << "too few for a small cube, enough for a large one";
  EXPECT_EQ(share(Vec3f(61.0F), 200), kAliasUnits - 1) << "the same large cube";
  EXPECT_EQ(startAt(guide, Vec3f(32.0F)), kNoGuide);
}

/// In a plane, on a line and in a point.
TEST(Guide, HasRoomForFlatScenes) {
  for (const Vec3f& extent : {Vec3f(1.0F, 0.0F, 1.0F), Vec3f(0.0F, 0.0F, 1.0F), Vec3f(0.0F)}) {
    std::vector<Photon> found;
    for (int i = 0; i < 64; ++i)
      found.push_back(photonAt(Vec3f(5.0F) + extent * (static_cast<float>(i) / 63.0F), 3));
    const Guide guide = makeGuide(found);
    EXPECT_TRUE(std::ranges::all_of(found, [&](const Photon& p) { return startAt(guide, p.p) != kNoGuide; }));
  }
}

} // namespace
} // namespace vkpt::test
