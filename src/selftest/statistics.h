#pragma once
// Statistical tests of films (hypothesis tests have a bound derived from the number of tests).

#include "film/film.h"

#include <span>

namespace vkpt::selftest {

/// Probability with which one family of tests may fail by chance alone.
inline constexpr double kFamilyAlpha = 1e-3;

/// Two-sided bound of |z| for `tests` normal statistics of which none may exceed it but with probability
/// `alpha`: Šidák's correction.
double sidakBound(std::size_t tests, double alpha = kFamilyAlpha);

/// Figures of a set of pixels, per channel.
struct Estimate {
  Vec3d mean{0.0};
  Vec3d variance{0.0}; ///< of the mean
};
Estimate estimateOf(const Film& film);
/// 8x8 tiles, those at the edges smaller; row by row.
std::vector<Estimate> tileEstimates(const Film& film);

/// (a - b) / sqrt(var a + var b), Welch's statistic; 0 for equal means without variance, infinite for
/// different ones.
Vec3d welch(const Estimate& a, const Estimate& b);
double maxAbs(const Vec3d& v);

/// Pearson's correlation coefficient.
double correlation(std::span<const double> a, std::span<const double> b);

/// To the last bit: counts, means and squared deviations of all pixels.
bool identical(const Film& a, const Film& b);

} // namespace vkpt::selftest
