#pragma once
// From the measured points to what a reader wants to know. Relative errors are sqrt(relMSE).

#include "study/study_result.h"

#include <optional>
#include <vector>

namespace vkpt {

/// Over the seeds.
struct Spread {
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;
};
/// Nothing without values.
std::optional<Spread> spreadOf(std::vector<double> values);

/// A mean over seeds with its standard error, which two seeds or more tell.
struct Estimate {
  double value = 0.0;
  std::optional<double> standardError;
};
std::optional<Estimate> estimateOf(const std::vector<double>& values);

/// relMSE after some rendering: between two points a straight line between logarithms. Nothing outside of
/// them.
std::optional<double> relMseAt(const StudyRun& run, double seconds);

struct TimeToError {
  double seconds = 0.0;
  bool extrapolated = false; ///< along the fitted line: the run did not get there
  bool beyond = false;       ///< it takes longer than `seconds`, which is as far as a line is trusted
};
/// When the relative error falls below `error` for the first time. Nothing where it does not fall.
std::optional<TimeToError> timeTo(const StudyRun& run, double error);

/// A line that was fitted to a run is followed to this many times its length: a tenth of its last error.
inline constexpr double kFarthestExtrapolation = 100.0;

/// The relative errors that the table of times is for: 5 %, 2 %, 1 %, and the target.
std::vector<double> errorLevels(const StudyResult& result);

/// A point of the curve that stands for a setting: medians over the seeds at equal frames, or at each one's
/// end.
struct CurvePoint {
  double frames = 0.0;
  double seconds = 0.0;
  Spread error; ///< relative
};

/// What a line is fitted to: the points from 8 frames on, where there are three or more of them. Before, time
/// a sample is not what it will be.
std::vector<CurvePoint> settledPart(const std::vector<CurvePoint>& curve);

struct SettingSummary {
  std::string name;
  std::vector<CurvePoint> curve;
  std::optional<Estimate> slopeOverTime;   ///< of log relMSE against log time; -1 for independent samples
  std::optional<Estimate> slopeOverFrames; ///< against log frames
  std::optional<Spread> errorAtEqualTime;
  std::optional<Spread> errorAtEqualFrames;
  /// To errorLevels(), medians. A bias ends the fall of the error: what it has not reached yet, it never may.
  std::vector<std::optional<TimeToError>> times;
  /// relMSE at the end beyond what the runs' variances tell: of a bias, what no time removes; else about 0.
  std::optional<Estimate> lastingRelMse;
  std::optional<double> measuredOverPredicted; ///< relative errors at the end, median; 1 for honest ones
  /// 1 / (relMSE x time) at equal time, over that of the first setting.
  std::optional<double> efficiency;
  double secondsPerFrame = 0.0;
  /// Of the image's mean, channels alike, against the reference: -0.1 lacks a tenth of the light. The error
  /// takes the channels as fully correlated, so it is rather too large.
  Estimate energy;
  /// `energy` is beyond three standard errors: the setting is biased, or the reference too noisy.
  [[nodiscard]] bool isBiased() const;
};

/// Shares of the whole that leaving something out saves and loses.
struct Ablation {
  double timeSaved = 0.0; ///< of a sample of every pixel
  double energyLost = 0.0;
};
Ablation ablationOf(const SettingSummary& whole, const SettingSummary& rest);

std::vector<SettingSummary> summarise(const StudyResult& result);

} // namespace vkpt
