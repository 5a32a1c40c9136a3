// vkpt study: what accuracy costs in time.

#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/output_folder.h"
#include "app/status_line.h"
#include "app/study_run.h"
#include "core/clock.h"
#include "core/duration.h"

#include <fmt/format.h>

#include <algorithm>

namespace vkpt {
namespace {

std::string ablationText(const std::vector<SettingSummary>& summaries, std::size_t width) {
  std::string text = fmt::format("{:<{}}  time saved  energy lost\n", "left out", width);
  for (std::size_t i = 1; i < summaries.size(); ++i) {
    const Ablation a = ablationOf(summaries.front(), summaries[i]);
    text += fmt::format("{:<{}}  {:>8.1f} %  {:>9.2f} %\n", summaries[i].name, width, a.timeSaved * 100.0,
                        a.energyLost * 100.0);
  }
  return text;
}

std::string errorText(const std::vector<SettingSummary>& summaries, std::size_t width, double seconds) {
  const auto slope = [](const std::optional<Estimate>& e) {
    if (!e)
      return std::string("-");
    return fmt::format("{:.2f}", e->value) +
           (e->standardError ? fmt::format(" ± {:.2f}", *e->standardError) : std::string());
  };
  std::string text = fmt::format("{:<{}}  error after {:.3g} s  efficiency  slope over time    energy\n",
                                 "setting", width, seconds);
  for (const auto& s : summaries) {
    const std::string error =
        s.errorAtEqualTime ? fmt::format("{:.3g} %", s.errorAtEqualTime->median * 100.0) : "-";
    text += fmt::format("{:<{}}  {:>18}  {:>10}  {:>15}  {:>+6.2f} %\n", s.name, width, error,
                        s.efficiency ? fmt::format("{:.3g}", *s.efficiency) : "-", slope(s.slopeOverTime),
                        s.energy.value * 100.0);
  }
  return text;
}

std::string summaryText(const StudySection& section) {
  const StudyResult& result = section.result;
  const auto summaries = summarise(result);
  std::size_t width = 8;
  for (const auto& s : summaries)
    width = std::max(width, s.name.size());
  std::string text = section.facts.scene + "\n";
  text += result.ablation ? ablationText(summaries, width) : errorText(summaries, width, result.equalSeconds);
  for (const auto& remark : remarks(result, summaries))
    text += remark + "\n";
  return text;
}

/// One scene after the other; the line on stderr tells of all of them.
std::vector<StudySection> runAll(const StudyOptions& o, const std::vector<LoadedStudy>& studies,
                                 const gpu::Context& context) {
  std::vector<StudySection> sections;
  StatusLine line(o.common.progress);
  const Stopwatch watch;
  for (const LoadedStudy& study : studies) {
    const auto observer = [&](const StudyProgress& p) {
      if (line.isDue()) {
        const double share =
            (static_cast<double>(sections.size()) + p.share) / static_cast<double>(studies.size());
        const double left = p.secondsLeft * (1.0 - share) * static_cast<double>(studies.size()) /
                            std::max(1.0 - p.share, 1e-3);
        line.draw(fmt::format("{:.0f} %, {} left, {}: {}", share * 100.0, durationText(left),
                              study.scene.name, p.what));
      }
      return !InterruptGuard::requested();
    };
    sections.push_back(runLoaded(o, study, context, observer));
    if (sections.back().result.stop == StudyStop::User)
      break;
  }
  return sections;
}

/// All that was neither rendering nor loading nor compiling, against rendering.
std::string overheadText(const std::vector<StudySection>& sections, double reportSeconds) {
  double rendering = 0.0, overhead = reportSeconds;
  for (const StudySection& section : sections) {
    rendering += section.result.renderSeconds + section.result.referenceSeconds;
    overhead += section.result.overheadSeconds;
  }
  return fmt::format("rendering {}, of that on top: {:.1f} % for measuring, taking turns and the report\n",
                     durationText(rendering), 100.0 * overhead / std::max(rendering, 1e-9));
}

ExitCode worstOf(const std::vector<StudySection>& sections) {
  ExitCode code = ExitCode::Done;
  for (const StudySection& section : sections)
    code = std::max(code, exitCodeOf(section.result)); // an interrupt is the largest
  return code;
}

} // namespace

ExitCode runStudy(const std::vector<std::string>& arguments) {
  const auto o = parseStudyOptions(arguments);
  if (!o)
    return ExitCode::Done;
  setUpLog(o->common.log);
  checkGnuplot();
  checkFolder(o->folder, o->force);
  const InterruptGuard interrupts;
  const std::vector<LoadedStudy> studies = loadStudies(*o);
  const gpu::Context context({o->common.device, o->common.validation, pipelineCacheFolder()});
  makeFolder(o->folder, "report.html");
  const std::vector<StudySection> sections = runAll(*o, studies, context);
  const Stopwatch watch;
  writeReport(o->folder, sections);
  if (o->common.log != LogLevel::Quiet) {
    for (const StudySection& section : sections)
      fmt::print("{}", summaryText(section));
    fmt::print("{}written: {}\n", overheadText(sections, watch.seconds()),
               (o->folder / "report.html").string());
  }
  if (context.validationMessages() > 0)
    throw DeviceError("the Vulkan validation layer had something to say, see above");
  return worstOf(sections);
}

} // namespace vkpt
