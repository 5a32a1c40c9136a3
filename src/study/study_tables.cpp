#include "study/study_tables.h"

#include "core/duration.h"
#include "study/html.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

std::string cell(const std::optional<Spread>& s) {
  if (!s)
    return "–";
  return fmt::format("{} <span class=note>({:.3g}–{:.3g})</span>", percent(s->median), s->least * 100.0,
                     s->most * 100.0);
}

std::string cell(const std::optional<Estimate>& e) {
  if (!e)
    return "–";
  return fmt::format("{:.2f}", e->value) +
         (e->standardError ? fmt::format(" ± {:.2f}", *e->standardError) : std::string());
}

std::string cell(const std::optional<TimeToError>& t) {
  if (!t)
    return "–";
  return (t->beyond ? "&gt; " : t->extrapolated ? "≈ " : "") + durationText(t->seconds);
}

std::string cell(const std::optional<double>& value) { return value ? fmt::format("{:.3g}", *value) : "–"; }

std::string energyCell(const SettingSummary& s) {
  return fmt::format("{:+.2f} %{}", s.energy.value * 100.0,
                     s.energy.standardError ? fmt::format(" ± {:.2f}", *s.energy.standardError * 100.0) : "");
}

std::string equalTimeTable(const StudyResult& result, const std::vector<SettingSummary>& summaries) {
  std::vector<std::vector<std::string>> rows;
  for (const SettingSummary& s : summaries)
    rows.push_back({html::escaped(s.name), cell(s.errorAtEqualTime), cell(s.errorAtEqualFrames),
                    cell(s.efficiency), fmt::format("{:.3g} ms", s.secondsPerFrame * 1e3)});
  return "<h3>Equal time, equal samples</h3>" +
         html::table({"setting", fmt::format("error after {:.3g} s", result.equalSeconds),
                      fmt::format("error after {} samples a pixel", result.equalFrames), "efficiency",
                      "time a sample"},
                     rows) +
         "<p class=note>Relative errors, medians over the seeds with the least and the largest. Efficiency: "
         "1 / (relMSE × time), over that of the first setting. Time a sample: one for every pixel.</p>";
}

std::string equalErrorTable(const StudyResult& result, const std::vector<SettingSummary>& summaries) {
  std::vector<std::string> head{"setting"};
  for (const double level : errorLevels(result))
    head.push_back(fmt::format("time to {:.3g} %", level * 100.0));
  std::vector<std::vector<std::string>> rows;
  for (const SettingSummary& s : summaries) {
    rows.push_back({html::escaped(s.name)});
    for (const auto& time : s.times)
      rows.back().push_back(cell(time));
  }
  return "<h3>Equal error</h3>" + html::table(head, rows) +
         fmt::format(
             "<p class=note>≈: beyond what was rendered, along the fitted slope, followed to {:g} times "
             "the rendered time at most (&gt;). –: by what was measured, never.</p>",
             kFarthestExtrapolation);
}

std::string fitTable(const std::vector<SettingSummary>& summaries) {
  std::vector<std::vector<std::string>> rows;
  for (const SettingSummary& s : summaries)
    rows.push_back({html::escaped(s.name), cell(s.slopeOverTime), cell(s.slopeOverFrames), energyCell(s),
                    cell(s.measuredOverPredicted)});
  return "<h3>Slopes, energy, and whether the runs knew their error</h3>" +
         html::table({"setting", "slope over time", "slope over samples", "energy against the reference",
                      "error: measured / predicted"},
                     rows) +
         "<p class=note>Slopes of log relMSE, means over the seeds with their standard errors; independent "
         "samples have −1. Energy: of the image's mean; what a bias adds or takes. Predicted: by the run's "
         "own "
         "variances; 1 is honest, more is a bias, or a tail too heavy for a standard error.</p>";
}

} // namespace

std::string percent(double share) { return fmt::format("{:.3g} %", share * 100.0); }

std::string mainTables(const StudyResult& result, const std::vector<SettingSummary>& summaries) {
  return equalTimeTable(result, summaries) + equalErrorTable(result, summaries) + fitTable(summaries);
}

std::string ablationTable(const std::vector<SettingSummary>& summaries) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 1; i < summaries.size(); ++i) {
    const SettingSummary& s = summaries[i];
    const Ablation a = ablationOf(summaries.front(), s);
    rows.push_back({html::escaped(s.name), fmt::format("{:+.1f} %", a.timeSaved * 100.0),
                    fmt::format("{:+.2f} %", a.energyLost * 100.0), cell(s.errorAtEqualTime)});
  }
  return "<h3>What each part costs</h3>" +
         html::table({"left out", "time saved", "energy lost", "error that stays"}, rows) +
         "<p class=note>Against the whole: time for a sample of every pixel, and the image's mean.</p>";
}

std::string biasTable(const StudyResult& result, const std::vector<SettingSummary>& summaries) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const SettingSummary& s = summaries[i];
    const auto& names = result.settings[i].setting.bias;
    if (names.empty() && !s.isBiased())
      continue;
    const double lasting = s.lastingRelMse ? s.lastingRelMse->value : 0.0;
    rows.push_back(
        {html::escaped(s.name),
         names.empty() ? "no option that says so" : html::escaped(fmt::format("{}", fmt::join(names, ", "))),
         energyCell(s), lasting > 0.0 ? percent(std::sqrt(lasting)) : "not to be seen"});
  }
  if (rows.empty())
    return {};
  return "<h3>The cost of bias</h3>" +
         html::table({"setting", "biased by", "energy against the reference", "error that no time removes"},
                     rows) +
         "<p class=note>The last column: sqrt of what relMSE has at the end beyond the variance of the run's "
         "own "
         "samples.</p>";
}

std::vector<std::string> overviewHead() {
  return {"scene", "setting", "error at equal time", "error at equal samples", "efficiency", "energy"};
}

std::vector<std::vector<std::string>> overviewRows(const std::string& scene, const StudyResult& result,
                                                   const std::vector<SettingSummary>& summaries) {
  std::vector<std::vector<std::string>> rows;
  for (const SettingSummary& s : summaries)
    rows.push_back(
        {rows.empty() ? fmt::format("{} ({:.3g} s)", html::escaped(scene), result.equalSeconds) : "",
         html::escaped(s.name), cell(s.errorAtEqualTime), cell(s.errorAtEqualFrames), cell(s.efficiency),
         energyCell(s)});
  return rows;
}

} // namespace vkpt
