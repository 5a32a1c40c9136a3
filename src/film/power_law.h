#pragma once
// How an error falls: a straight line between logarithms.

#include <optional>
#include <span>

namespace vkpt {

/// An error after some work; what work counts (frames, seconds) is the caller's choice. Both above 0.
struct ErrorAtWork {
  double work = 0.0;
  double error = 0.0;
};

/// error = factor * work^exponent. Independent samples: exponent -1/2 for a standard error, -1 for its
/// square.
struct PowerLaw {
  double exponent = 0.0;
  double factor = 0.0;
  [[nodiscard]] double errorAfter(double work) const;
  /// Nothing where the error does not fall.
  [[nodiscard]] std::optional<double> workFor(double error) const;
};

/// Least squares between the logarithms. Nothing with fewer than two different amounts of work; points that
/// are not finite and above 0 are left out.
std::optional<PowerLaw> fitPowerLaw(std::span<const ErrorAtWork> points);

/// What a smaller error would cost.
struct CostOfError {
  double more = 0.0;     ///< work beyond what was done, in its unit
  double exponent = 0.0; ///< by which the error falls
  bool measured = false; ///< else the law of independent samples, -1/2, for want of looks
};

/// To lower the error to `share` of what it is, 0 < share < 1. `looks` are the run's errors so far, the last
/// one of the whole run, after `work` of whatever unit the answer is wanted in. Measured with three looks or
/// more. Nothing while no error is known, or where the measured one does not fall.
std::optional<CostOfError> costOfError(double share, std::span<const ErrorAtWork> looks, double work);

} // namespace vkpt
