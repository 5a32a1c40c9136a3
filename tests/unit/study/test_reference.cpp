// Errors against a reference that has noise of its own, on films whose truth is known.

#include "study/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vkpt {
namespace {

constexpr double kTruth = 2.0;     // radiance of every pixel
constexpr double kDeviation = 0.5; // of one sample, in every channel
constexpr int kSide = 64;

/// Samples of a normal distribution, channels alike.
Film noisyFilm(std::uint64_t samples, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(kTruth, kDeviation);
  Film film{kSide, kSide, std::vector<PixelMoments>(static_cast<std::size_t>(kSide) * kSide)};
  for (PixelMoments& pixel : film.pixels) {
    for (std::uint64_t s = 0; s < samples; ++s)
      pixel.merge({1, Vec3d(normal(random)), Vec3d(0.0)});
  }
  return film;
}

/// Of the mean over pixels of squared normal deviates of this variance: five standard errors,
/// sqrt(2 / pixels) each.
double tolerance(double variance) { return 5.0 * variance * std::sqrt(2.0 / (kSide * kSide)); }

TEST(Reference, KnowsItsOwnNoise) {
  const Reference reference(noisyFilm(50, 1));
  const double variance = kDeviation * kDeviation / 50.0;
  EXPECT_TRUE(reference.noiseIsKnown());
  EXPECT_NEAR(reference.noise().mse, variance, tolerance(variance));
  EXPECT_NEAR(reference.mean().x, kTruth, 5.0 * std::sqrt(variance) / kSide);
  EXPECT_NEAR(reference.standardError().x, std::sqrt(variance) / kSide, 0.05 * std::sqrt(variance) / kSide);
}

TEST(Reference, MeasuresTheErrorPlusItsOwnNoise) {
  const Reference reference(noisyFilm(40, 2));
  for (const std::uint64_t samples : {4U, 10U, 40U}) {
    const double error = kDeviation * kDeviation / static_cast<double>(samples);
    const double own = kDeviation * kDeviation / 40.0;
    const SquaredError measured = reference.measure(noisyFilm(samples, 3));
    EXPECT_NEAR(measured.mse, error + own, tolerance(error + own)) << samples;
    EXPECT_NEAR(measured.mse - reference.noise().mse, error, tolerance(error + 2.0 * own)) << samples;
    const double floor = 0.01 * kTruth * 0.01 * kTruth;
    // b^2 scatters about kTruth^2 by a few per cent
    EXPECT_NEAR(measured.relMse, (error + own) / (kTruth * kTruth + floor),
                1.1 * tolerance(error + own) / 4.0)
        << samples;
  }
}

TEST(Reference, PredictsTheErrorFromTheFilmsOwnVariances) {
  const Reference reference(noisyFilm(40, 2));
  const Film film = noisyFilm(20, 5);
  const double error = kDeviation * kDeviation / 20.0;
  // the mean of 3 * 64 * 64 sample variances of 20 each, channels alike
  EXPECT_NEAR(reference.predict(film).mse, error, 5.0 * error * std::sqrt(2.0 / 19.0) / kSide);
  EXPECT_NEAR(reference.measure(film).mse - reference.noise().mse, reference.predict(film).mse,
              tolerance(error + 2.0 * reference.noise().mse));
  EXPECT_EQ(reference.predict(noisyFilm(1, 6)).mse, 0.0);
}

TEST(Reference, FromAFileTellsWhatTheFileTells) {
  const Film film = noisyFilm(20, 4);
  const Reference rendered(film);
  const Reference withErrors(develop(film));
  EXPECT_TRUE(withErrors.noiseIsKnown());
  EXPECT_NEAR(withErrors.noise().mse, rendered.noise().mse, 1e-6 * rendered.noise().mse);
  EXPECT_NEAR(withErrors.noise().relMse, rendered.noise().relMse, 1e-6 * rendered.noise().relMse);
  const Reference without(develop(film, {false}));
  EXPECT_FALSE(without.noiseIsKnown());
  EXPECT_EQ(without.noise().mse, 0.0);
  EXPECT_NEAR(without.measure(film).mse, 0.0, 1e-12);
}

TEST(Reference, LeavesOutPixelsThatAreNotFinite) {
  Image image(2, 1, {"R", "G", "B"});
  for (auto& channel : image.channels)
    channel.values = {1.0F, NAN};
  Film film{2, 1, std::vector<PixelMoments>(2)};
  film.pixels[0].mean = Vec3d(3.0);
  const Reference reference(image);
  EXPECT_EQ(reference.mean(), Vec3d(1.0));
  EXPECT_DOUBLE_EQ(reference.measure(film).mse, 4.0);
  EXPECT_DOUBLE_EQ(reference.measure(film).relMse, 4.0 / 1.0001);
}

} // namespace
} // namespace vkpt
