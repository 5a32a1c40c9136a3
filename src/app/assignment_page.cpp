#include "app/assignment_answers.h"
#include "core/duration.h"
#include "film/file_io.h"
#include "study/html.h"
#include "study/report_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

constexpr double kHopeless = 10.0; // a relative error beyond which figures tell nothing

constexpr const char* kSheetStyle = R"(
.plate figure img { width: 19rem; } .plate figcaption { max-width: 19rem; }
.annotated { width: 100%; max-width: 46rem; }
pre { background: #f6f6f6; padding: .6rem; font-size: .78rem; overflow-x: auto; }
blockquote { color: #555; border-left: 3px solid #ccc; margin-left: 0; padding-left: .8rem; }
)";

/// Every picture with the command that makes it.
std::string commands(const AssignmentResults& results) {
  std::vector<std::vector<std::string>> rows;
  for (const DrawnPicture& d : results.pictures)
    rows.push_back({fmt::format("<code>{}</code>.png, .exr", d.picture->name), std::string(d.picture->part),
                    fmt::format("<code>vkpt {}</code>", html::escaped(d.picture->arguments))});
  return "<h2>The pictures' commands</h2>" + html::table({"file", "task", "command"}, rows);
}

} // namespace

const RunReport* AssignmentBook::find(std::string_view name) const {
  for (const DrawnPicture& d : m_results.pictures) {
    if (d.picture->name == name)
      return &d.report;
  }
  return nullptr;
}

std::string AssignmentBook::samples(std::string_view name) const {
  const RunReport* r = find(name);
  if (r == nullptr)
    return "–";
  const double frames = r->result.frames;
  return frames == std::floor(frames) ? fmt::format("{:.0f}", frames) : fmt::format("{:.1f}", frames);
}

std::string AssignmentBook::seconds(std::string_view name) const {
  const RunReport* r = find(name);
  return r != nullptr ? durationText(r->seconds.render) : "–";
}

std::string AssignmentBook::error(std::string_view name) const {
  const RunReport* r = find(name);
  if (r == nullptr || !std::isfinite(r->film.relativeError))
    return "–";
  const char* mark = tailWarning(*r).empty() ? "" : "†";
  if (r->film.relativeError > kHopeless)
    return fmt::format("&gt; {:.0f} %{}", kHopeless * 100.0, mark);
  return fmt::format("{:.3g} %{}", r->film.relativeError * 100.0, mark);
}

std::string AssignmentBook::figures(std::initializer_list<std::string_view> names) const {
  std::string row;
  for (const DrawnPicture& d : m_results.pictures) {
    const std::string_view name = d.picture->name;
    if (std::ranges::find(names, name) != names.end())
      row += html::figure(
          "picture", m_folder / fmt::format("{}.png", name),
          fmt::format("{}. {} samples per pixel, {}", d.picture->caption, samples(name), seconds(name)));
  }
  return "<div class='row plate'>" + row + "</div>\n";
}

std::string AssignmentBook::table(std::initializer_list<std::string_view> names) const {
  std::vector<std::vector<std::string>> rows;
  for (const std::string_view name : names) {
    const RunReport* r = find(name);
    if (r == nullptr)
      continue;
    rows.push_back({std::string(name), samples(name), seconds(name),
                    fmt::format("{:.2f}", static_cast<double>(r->film.samples) /
                                              std::max(r->seconds.render, 1e-9) * 1e-6),
                    fmt::format("{:.3g}", static_cast<double>(r->counters.raysClosest) * 1e-6),
                    fmt::format("{:.3g}", static_cast<double>(r->counters.raysShadow) * 1e-6), error(name),
                    fmt::format("{:.4f} {:.4f} {:.4f}", r->film.mean.x, r->film.mean.y, r->film.mean.z)});
  }
  return html::table({"picture", "samples per pixel", "time", "million samples a second", "million rays",
                      "million shadow rays", "estimated error", "mean R G B"},
                     rows);
}

const DoneExperiment* AssignmentBook::experiment(std::string_view name) const {
  const auto found = std::ranges::find_if(m_results.experiments,
                                          [name](const auto& d) { return d.experiment->name == name; });
  return found == m_results.experiments.end() ? nullptr : &*found;
}

std::string AssignmentBook::study(std::string_view name) const {
  const DoneExperiment* done = experiment(name);
  if (done == nullptr)
    return {};
  const fs::path own = m_folder / name;
  fs::create_directories(own);
  film::writeTextFile(own / "results.csv", resultsCsv(done->section.result));
  film::writeTextFile(own / "results.json", resultsJson({done->section}));
  return fmt::format("<details open><summary>{}: <code>{}</code></summary>{}</details>",
                     html::escaped(done->experiment->title), html::escaped(done->section.facts.command),
                     studySection(own, done->section));
}

std::optional<double> samplesForEqualError(const SettingSummary& first, const SettingSummary& setting) {
  if (!first.errorAtEqualFrames || !setting.errorAtEqualFrames)
    return std::nullopt;
  return std::pow(setting.errorAtEqualFrames->median / first.errorAtEqualFrames->median, 2.0);
}

void writeAssignmentPage(const fs::path& folder, const AssignmentResults& results) {
  const AssignmentBook book(folder, results);
  const std::string title =
      results.sheet == Sheet::A ? "Worksheet 5: path tracing in the Cornell box" : "Exercise 4: path tracing";
  std::string body = fmt::format("<h1>{}</h1><p><code>{}</code></p>", title, html::escaped(results.command));
  if (!results.pictures.empty())
    body +=
        fmt::format("<p class=note>Rendered on {}. †: the samples' tail is so heavy that a standard error "
                    "means little.</p>",
                    html::escaped(results.pictures.front().report.device));
  if (!results.complete)
    body +=
        "<p class=remark>Not all of it: interrupted, or only some pictures were asked for. A dash stands for "
        "what was not rendered.</p>";
  body += results.sheet == Sheet::A ? answersOfA(book) : answersOfB(book);
  body += commands(results);
  film::writeTextFile(folder / "index.html",
                      html::page(title, std::string(kReportStyle) + kSheetStyle, body, kReportScript));
}

} // namespace vkpt
