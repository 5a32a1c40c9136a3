#include "study/study_analysis.h"

#include "film/power_law.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vkpt {
namespace {

constexpr double kSettledFrames = 8.0; // the first frames are small dispatches, which take longer a sample
constexpr std::size_t kLeastSettled = 3;

bool hasError(const StudyPoint& p) { return p.error.relMse > 0.0; }

/// relMSE by seconds or by frames.
std::vector<ErrorAtWork> curveOf(const StudyRun& run, bool byTime) {
  std::vector<ErrorAtWork> points;
  for (const StudyPoint& p : run.points) {
    if (hasError(p))
      points.push_back({byTime ? p.seconds : static_cast<double>(p.frames), p.error.relMse});
  }
  return points;
}

/// Of these, what a line is fitted to.
std::vector<ErrorAtWork> settledCurveOf(const StudyRun& run, bool byTime) {
  std::vector<ErrorAtWork> points;
  for (const StudyPoint& p : run.points) {
    if (hasError(p) && static_cast<double>(p.frames) >= kSettledFrames)
      points.push_back({byTime ? p.seconds : static_cast<double>(p.frames), p.error.relMse});
  }
  return points.size() >= kLeastSettled ? points : curveOf(run, byTime);
}

/// Along the line between two points in logarithms: the value that belongs to x.
double interpolate(double x0, double y0, double x1, double y1, double x) {
  if (x0 == x1)
    return y1;
  const double t = (std::log(x) - std::log(x0)) / (std::log(x1) - std::log(x0));
  return std::exp(std::log(y0) + t * (std::log(y1) - std::log(y0)));
}

template<class Function>
std::vector<double> overRuns(const SettingResult& setting, Function&& of) {
  std::vector<double> values;
  for (const StudyRun& run : setting.runs) {
    if (const std::optional<double> value = of(run))
      values.push_back(*value);
  }
  return values;
}

std::optional<Estimate> slope(const SettingResult& setting, bool byTime) {
  return estimateOf(overRuns(setting, [&](const StudyRun& run) -> std::optional<double> {
    const auto law = fitPowerLaw(settledCurveOf(run, byTime));
    return law ? std::optional(law->exponent) : std::nullopt;
  }));
}

Spread rootOf(const Spread& s) { return {std::sqrt(s.median), std::sqrt(s.least), std::sqrt(s.most)}; }

std::optional<Spread> rootOf(const std::optional<Spread>& s) { return s ? std::optional(rootOf(*s)) : s; }

/// Runs that have a point for these frames give it.
std::optional<CurvePoint> curvePoint(const SettingResult& setting, auto&& pick) {
  std::vector<double> frames, seconds, errors;
  for (const StudyRun& run : setting.runs) {
    const StudyPoint* p = pick(run);
    if (p == nullptr || !hasError(*p))
      return std::nullopt;
    frames.push_back(static_cast<double>(p->frames));
    seconds.push_back(p->seconds);
    errors.push_back(p->error.relMse);
  }
  if (errors.empty())
    return std::nullopt;
  return CurvePoint{spreadOf(frames)->median, spreadOf(seconds)->median, rootOf(*spreadOf(errors))};
}

const StudyPoint* pointAt(const StudyRun& run, std::uint64_t frames) {
  const auto found =
      std::ranges::find_if(run.points, [frames](const StudyPoint& p) { return p.frames == frames; });
  return found == run.points.end() ? nullptr : &*found;
}

std::vector<CurvePoint> medianCurve(const SettingResult& setting) {
  std::vector<CurvePoint> curve;
  if (setting.runs.empty())
    return curve;
  for (const StudyPoint& first : setting.runs.front().points) {
    if (const auto p = curvePoint(setting, [&](const StudyRun& run) { return pointAt(run, first.frames); }))
      curve.push_back(*p);
  }
  const auto end = curvePoint(setting, [](const StudyRun& run) { return &run.points.back(); });
  if (end && (curve.empty() || end->frames > curve.back().frames))
    curve.push_back(*end);
  return curve;
}

std::optional<TimeToError> medianTime(const SettingResult& setting, double error) {
  std::vector<TimeToError> times;
  for (const StudyRun& run : setting.runs) {
    const auto time = timeTo(run, error);
    if (!time)
      return std::nullopt;
    times.push_back(*time);
  }
  if (times.empty())
    return std::nullopt;
  std::ranges::sort(times, {}, &TimeToError::seconds);
  const TimeToError& low = times[(times.size() - 1) / 2];
  const TimeToError& high = times[times.size() / 2];
  return TimeToError{0.5 * (low.seconds + high.seconds),
                     std::ranges::any_of(times, &TimeToError::extrapolated), high.beyond};
}

/// Ends of runs whose variances are known.
std::vector<double> overEnds(const SettingResult& setting, auto&& of) {
  return overRuns(setting, [&](const StudyRun& run) -> std::optional<double> {
    const StudyPoint& end = run.points.back();
    return end.predicted > 0.0 ? std::optional<double>(of(end)) : std::nullopt;
  });
}

double meanOf(const Vec3d& v) { return (v.x + v.y + v.z) / 3.0; }

Estimate energyOf(const SettingResult& setting, const StudyResult& result) {
  double sum = 0.0, variance = 0.0;
  for (const StudyRun& run : setting.runs) {
    sum += meanOf(run.mean);
    const double error = meanOf(run.standardError);
    variance += error * error;
  }
  const auto n = static_cast<double>(setting.runs.size());
  const double reference = meanOf(result.referenceMean);
  if (n == 0.0 || !(reference > 0.0))
    return {};
  const double referenceError = meanOf(result.referenceMeanError);
  return {sum / n / reference - 1.0,
          std::sqrt(variance / (n * n) + referenceError * referenceError) / reference};
}

double secondsPerFrame(const SettingResult& setting) {
  const auto spread = spreadOf(overRuns(setting, [](const StudyRun& run) {
    const StudyPoint& end = run.points.back();
    return std::optional(end.seconds / static_cast<double>(end.frames));
  }));
  return spread ? spread->median : 0.0;
}

SettingSummary summaryOf(const SettingResult& setting, const StudyResult& result) {
  SettingSummary s;
  s.name = setting.setting.name;
  s.curve = medianCurve(setting);
  s.slopeOverTime = slope(setting, true);
  s.slopeOverFrames = slope(setting, false);
  s.errorAtEqualTime = rootOf(
      spreadOf(overRuns(setting, [&](const StudyRun& run) { return relMseAt(run, result.equalSeconds); })));
  s.errorAtEqualFrames = rootOf(spreadOf(overRuns(setting, [&](const StudyRun& run) -> std::optional<double> {
    const StudyPoint* p = pointAt(run, result.equalFrames);
    return p != nullptr && hasError(*p) ? std::optional(p->error.relMse) : std::nullopt;
  })));
  s.secondsPerFrame = secondsPerFrame(setting);
  s.energy = energyOf(setting, result);
  s.lastingRelMse =
      estimateOf(overEnds(setting, [](const StudyPoint& p) { return p.error.relMse - p.predicted; }));
  if (const auto ratio = spreadOf(overEnds(setting, [](const StudyPoint& p) {
        return std::sqrt(std::max(p.error.relMse, 0.0) / p.predicted);
      })))
    s.measuredOverPredicted = ratio->median;
  for (const double level : errorLevels(result)) {
    s.times.push_back(medianTime(setting, level));
    if (s.isBiased() && s.times.back() && s.times.back()->extrapolated)
      s.times.back().reset();
  }
  return s;
}

} // namespace

std::optional<Spread> spreadOf(std::vector<double> values) {
  if (values.empty())
    return std::nullopt;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return Spread{median, values.front(), values.back()};
}

std::optional<Estimate> estimateOf(const std::vector<double>& values) {
  if (values.empty())
    return std::nullopt;
  const auto n = static_cast<double>(values.size());
  double sum = 0.0;
  for (const double v : values)
    sum += v;
  Estimate e{sum / n, std::nullopt};
  if (values.size() < 2)
    return e;
  double squares = 0.0;
  for (const double v : values)
    squares += (v - e.value) * (v - e.value);
  e.standardError = std::sqrt(squares / (n * (n - 1.0)));
  return e;
}

std::optional<double> relMseAt(const StudyRun& run, double seconds) {
  const auto points = curveOf(run, true);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i].work <= seconds && seconds <= points[i + 1].work)
      return interpolate(points[i].work, points[i].error, points[i + 1].work, points[i + 1].error, seconds);
  }
  if (points.size() == 1 && points[0].work == seconds)
    return points[0].error;
  return std::nullopt;
}

std::optional<TimeToError> timeTo(const StudyRun& run, double error) {
  const double target = error * error;
  const auto points = curveOf(run, true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].error > target)
      continue;
    if (i == 0) // it was there at the first look
      return TimeToError{points[0].work, false, false};
    return TimeToError{
        interpolate(points[i - 1].error, points[i - 1].work, points[i].error, points[i].work, target), false,
        false};
  }
  const auto law = fitPowerLaw(settledCurveOf(run, true));
  if (!law || !(law->exponent < 0.0))
    return std::nullopt;
  const ErrorAtWork& end = points.back(); // on from here, as steep as the line
  const double times = std::pow(target / end.error, 1.0 / law->exponent);
  if (times > kFarthestExtrapolation)
    return TimeToError{end.work * kFarthestExtrapolation, true, true};
  return TimeToError{end.work * times, true, false};
}

std::vector<CurvePoint> settledPart(const std::vector<CurvePoint>& curve) {
  std::vector<CurvePoint> settled;
  std::ranges::copy_if(curve, std::back_inserter(settled),
                       [](const CurvePoint& p) { return p.frames >= kSettledFrames; });
  return settled.size() >= kLeastSettled ? settled : curve;
}

std::vector<double> errorLevels(const StudyResult& result) {
  std::vector<double> levels{0.05, 0.02, 0.01};
  if (result.targetError && std::ranges::find(levels, *result.targetError) == levels.end())
    levels.push_back(*result.targetError);
  return levels;
}

Ablation ablationOf(const SettingSummary& whole, const SettingSummary& rest) {
  return {1.0 - rest.secondsPerFrame / whole.secondsPerFrame,
          1.0 - (1.0 + rest.energy.value) / (1.0 + whole.energy.value)};
}

bool SettingSummary::isBiased() const {
  return energy.standardError && std::abs(energy.value) > 3.0 * *energy.standardError;
}

std::vector<SettingSummary> summarise(const StudyResult& result) {
  std::vector<SettingSummary> summaries;
  for (const SettingResult& setting : result.settings) {
    SettingSummary s = summaryOf(setting, result);
    const auto& first = summaries.empty() ? s : summaries.front();
    if (s.errorAtEqualTime && first.errorAtEqualTime)
      s.efficiency = std::pow(first.errorAtEqualTime->median / s.errorAtEqualTime->median, 2.0);
    summaries.push_back(std::move(s));
  }
  return summaries;
}

} // namespace vkpt
