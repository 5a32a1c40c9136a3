// The figures of the whole image against direct sums, and against the error that there is.

#include "unit/film/film_fixtures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vkpt::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Film filmOf(int width, int height) {
  Film film{width, height, {}};
  film.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return film;
}

/// Every pixel gets `samples` values, uniform in [0, 2 a) of its own a, which goes into `truth`: blocks of
/// 4x4 pixels with edges and corners between them.
Film sampledFilm(int width, int height, int samples, std::mt19937_64& random, std::vector<Vec3d>& truth) {
  Film film = filmOf(width, height);
  std::uniform_real_distribution<double> uniform;
  truth.clear();
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    const std::size_t x = i % static_cast<std::size_t>(width), y = i / static_cast<std::size_t>(width);
    const auto a = static_cast<double>(1 + (x / 4 + y / 4) % 5);
    truth.emplace_back(a, 0.5 * a, 2.0);
    for (int s = 0; s < samples; ++s) {
      const Vec3d u(uniform(random), uniform(random), uniform(random));
      film.pixels[i].merge({1, 2.0 * truth.back() * u, Vec3d(0.0)});
    }
  }
  return film;
}

/// The pixel and its four neighbours, mirrored at the border.
long double medianOfCross(const Film& film, int x, int y, int channel) {
  const auto mirrored = [](int i, int n) { return i < 0 ? 1 : i >= n ? n - 2 : i; };
  std::vector<double> values{film.at(x, y).mean[channel]};
  for (const int step : {-1, 1}) {
    values.push_back(film.at(mirrored(x + step, film.width), y).mean[channel]);
    values.push_back(film.at(x, mirrored(y + step, film.height)).mean[channel]);
  }
  std::sort(values.begin(), values.end());
  return values[2];
}

/// Of 400 films, about 380 bound what the estimate estimates: its square's expectation. The limits are
/// the 99.9 % points of the binomial distribution, loosened below for the skewness that a normal quantile
/// leaves out.
TEST(FilmStatistics, TheUpperBoundOfTheErrorHoldsIn95OfACentury) {
  auto random = randomOfTest();
  std::vector<Vec3d> truth;
  std::vector<FilmStatistics> films;
  double expected = 0.0;
  for (int i = 0; i < 400; ++i) {
    films.push_back(filmStatistics(sampledFilm(20, 20, 8, random, truth)));
    expected += films.back().relativeError * films.back().relativeError / 400.0;
  }
  int held = 0;
  for (const FilmStatistics& f : films) {
    EXPECT_GT(f.relativeErrorUpper, f.relativeError);
    held += f.relativeErrorUpper * f.relativeErrorUpper >= expected ? 1 : 0;
  }
  EXPECT_GE(held, 362);
  EXPECT_LE(held, 393);
}

TEST(FilmStatistics, EqualDirectSums) {
  auto random = randomOfTest();
  std::vector<Vec3d> truth;
  Film film = sampledFilm(7, 5, 6, random, truth);
  film.pixels[3].merge({5, {100.0, 0.0, 3.0}, {4.0, 1.0, 0.0}});
  long double mean[3] = {}, variance[3] = {}, all = 0.0L, relative = 0.0L;
  for (const PixelMoments& p : film.pixels) {
    const auto n = static_cast<long double>(p.count);
    for (int c = 0; c < 3; ++c) {
      mean[c] += p.mean[c] / 35.0L;
      variance[c] += p.m2[c] / (n * (n - 1.0L));
      all += p.mean[c] / 105.0L;
    }
  }
  for (int i = 0; i < 35; ++i)
    for (int c = 0; c < 3; ++c) {
      const PixelMoments& p = film.at(i % 7, i / 7);
      const auto n = static_cast<long double>(p.count);
      const long double square = p.m2[c] / (n * (n - 1.0L));
      long double b = p.mean[c];
      if (square >= b * b / 64.0L)
        b = medianOfCross(film, i % 7, i / 7, c);
      relative += square / (b * b + 1e-4L * all * all) / 105.0L;
    }
  const FilmStatistics s = filmStatistics(film);
  const double tolerance = 1e-13; // 35 roundings of 1.1e-16 and some, relative
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(s.mean[c], static_cast<double>(mean[c]), tolerance * s.mean[c]);
    const auto error = static_cast<double>(std::sqrt(variance[c]) / 35.0L);
    EXPECT_NEAR(s.standardError[c], error, tolerance * error);
  }
  EXPECT_NEAR(s.relativeError, static_cast<double>(std::sqrt(relative)), tolerance * s.relativeError);
  EXPECT_EQ(s.samples, 35U * 6U + 5U);
  EXPECT_EQ(s.nonFinitePixels, 0U);
}

/// Of 400 films, (mean - truth)^2 / standardError^2 averages 1. Its own standard error is sqrt(2 / (400 * 3))
/// = 0.041 (z^2 has variance 2, three channels); 8 samples a pixel over 64 pixels leave 1 + 2/400 of
/// Student's t. The ratio of relMSE to its estimate is that of sums over 192 such terms, and better known.
TEST(FilmStatistics, ErrorsAreThoseThatThereAre) {
  auto random = randomOfTest();
  constexpr int kFilms = 400;
  double zSquared = 0.0, relMse = 0.0, estimate = 0.0;
  for (int f = 0; f < kFilms; ++f) {
    std::vector<Vec3d> truth;
    const Film film = sampledFilm(8, 8, 8, random, truth);
    const FilmStatistics s = filmStatistics(film);
    Vec3d mean(0.0);
    for (const Vec3d& t : truth)
      mean += t / 64.0;
    const double m = (mean.x + mean.y + mean.z) / 3.0;
    for (int c = 0; c < 3; ++c) {
      zSquared += std::pow((s.mean[c] - mean[c]) / s.standardError[c], 2.0) / (3.0 * kFilms);
      for (std::size_t i = 0; i < truth.size(); ++i)
        relMse +=
            std::pow(film.pixels[i].mean[c] - truth[i][c], 2.0) / (truth[i][c] * truth[i][c] + 1e-4 * m * m);
    }
    estimate += 192.0 * s.relativeError * s.relativeError;
  }
  EXPECT_NEAR(zSquared, 1.005, 4.0 * 0.041);
  // The median about a pixel stands for b: E[1 / b^2] is larger by 3 var(b) / b^2 at first order, var of the
  // median of five about 1.4 / 5 of a pixel's own, 1 / (3 * 8).
  EXPECT_GT(estimate / relMse, 0.95);
  EXPECT_LT(estimate / relMse, 1.15);
}

/// Of a thousand pixels a few meet a sample of a hundred times their light, each with a probability that
/// makes it half of it. Whoever meets one has a large mean and a large error: their quotient alone would hide
/// the error.
TEST(FilmStatistics, RareBrightSamplesDoNotHideTheirError) {
  auto random = randomOfTest();
  std::bernoulli_distribution rare(0.005);
  constexpr int kSide = 32, kSamples = 40;
  double relMse = 0.0, estimate = 0.0;
  for (int f = 0; f < 50; ++f) {
    Film film = filmOf(kSide, kSide);
    for (PixelMoments& p : film.pixels)
      for (int s = 0; s < kSamples; ++s)
        p.merge({1, Vec3d(rare(random) ? 100.5 : 0.5), Vec3d(0.0)});
    estimate += std::pow(filmStatistics(film).relativeError, 2.0);
    for (const PixelMoments& p : film.pixels)
      relMse += std::pow(p.mean.x - 1.0, 2.0) / 1.0001 / (kSide * kSide);
  }
  const double ratio = std::sqrt(relMse / estimate); // a for b: 2.9
  EXPECT_GT(ratio, 0.4); // the median is that of pixels without a rare sample, half as bright
  EXPECT_LT(ratio, 1.1);
}

TEST(FilmStatistics, PixelsThatAreNotFiniteAreLeftOutAndCounted) {
  auto random = randomOfTest();
  std::vector<Vec3d> truth;
  const Film clean = sampledFilm(4, 1, 5, random, truth);
  const FilmStatistics expected = filmStatistics(clean);
  Film film = filmOf(8, 1);
  for (std::size_t i = 0; i < 4; ++i)
    film.pixels[2 * i] = clean.pixels[i];
  film.pixels[1] = {5, {1.0, std::nan(""), 1.0}, Vec3d(1.0)};
  film.pixels[3] = {1, {1.0, 1.0, kInfinity}, Vec3d(0.0)};
  film.pixels[5] = {5, Vec3d(1.0), {kInfinity, 0.0, 0.0}};
  film.pixels[7] = {5, {-kInfinity, 1.0, 1.0}, Vec3d(0.0)};
  const FilmStatistics s = filmStatistics(film);
  EXPECT_EQ(s.nonFinitePixels, 4U);
  EXPECT_EQ(s.samples, 20U + 16U);
  EXPECT_EQ(s.mean, expected.mean);
  EXPECT_EQ(s.standardError, expected.standardError);
  EXPECT_EQ(s.relativeError, expected.relativeError);
}

TEST(FilmStatistics, ErrorsAreInfiniteWhileAPixelHasFewerThanTwoSamples) {
  Film film = filmOf(2, 2);
  FilmStatistics s = filmStatistics(film); // no sample at all
  EXPECT_EQ(s.mean, Vec3d(0.0));
  EXPECT_EQ(s.standardError, Vec3d(kInfinity));
  EXPECT_EQ(s.relativeError, kInfinity);
  for (PixelMoments& p : film.pixels)
    p = {4, Vec3d(2.0), Vec3d(1.0)};
  EXPECT_LT(filmStatistics(film).relativeError, 1.0);
  film.pixels[1] = {1, Vec3d(6.0), Vec3d(0.0)};
  s = filmStatistics(film);
  EXPECT_EQ(s.mean, Vec3d(3.0));
  EXPECT_EQ(s.standardError, Vec3d(kInfinity));
  EXPECT_EQ(s.relativeError, kInfinity);
  film.pixels[1] = {}; // not measured: no part of the mean either
  s = filmStatistics(film);
  EXPECT_EQ(s.mean, Vec3d(2.0));
  EXPECT_EQ(s.relativeError, kInfinity);
}

TEST(FilmStatistics, ABlackImageHasNoError) {
  Film film = filmOf(3, 2);
  for (PixelMoments& p : film.pixels)
    p = {9, Vec3d(0.0), Vec3d(0.0)};
  const FilmStatistics s = filmStatistics(film);
  EXPECT_EQ(s.mean, Vec3d(0.0));
  EXPECT_EQ(s.standardError, Vec3d(0.0));
  EXPECT_EQ(s.relativeError, 0.0);
}

TEST(Develop, GivesMeansAndStandardErrors) {
  Film film = filmOf(2, 1);
  film.pixels[0] = {4, {0.25, -1.0, 3e38}, {12.0, 48.0, 0.0}};
  film.pixels[1] = {1, {0.1, kInfinity, 0.0}, Vec3d(0.0)};
  const Image image = develop(film);
  ASSERT_EQ(image.channels.size(), 6U);
  const char* names[] = {"R", "G", "B", "stderr.R", "stderr.G", "stderr.B"};
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_EQ(image.channels[c].name, names[c]);
  EXPECT_EQ(image.find("R")->values, (std::vector<float>{0.25F, 0.1F}));
  EXPECT_EQ(image.find("G")->values, (std::vector<float>{-1.0F, static_cast<float>(kInfinity)}));
  EXPECT_EQ(image.find("B")->values, (std::vector<float>{3e38F, 0.0F}));
  EXPECT_EQ(image.find("stderr.R")->values, (std::vector<float>{1.0F, 0.0F}));
  EXPECT_EQ(image.find("stderr.G")->values, (std::vector<float>{2.0F, 0.0F}));
  EXPECT_EQ(image.find("stderr.B")->values, (std::vector<float>{0.0F, 0.0F}));
  EXPECT_EQ(image.find("A"), nullptr);
  EXPECT_EQ(develop(film, {.standardErrorLayer = false}).channels.size(), 3U);
}

} // namespace
} // namespace vkpt::test
