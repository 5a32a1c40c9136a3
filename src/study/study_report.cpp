// report.html and the pictures that it holds.

#include "study/study_report.h"

#include "film/compare.h"
#include "film/file_io.h"
#include "study/html.h"
#include "study/report_style.h"
#include "study/study_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace vkpt {
namespace {

constexpr double kEqualTime = 0.1; // share by which times may differ and still be called equal

std::string plots(const fs::path& folder) {
  std::string html = "<h3>Error against time, and against samples</h3>";
  for (const char* name : {"error-time", "error-frames"}) {
    const fs::path file = folder / (std::string(name) + ".svg");
    if (fs::exists(file))
      html += fmt::format("<img class=plot alt='{}' src='{}'>\n", name, html::dataUrl(file, "image/svg+xml"));
  }
  return html +
         "<p class=note>Points: medians over the seeds, bars from the least to the largest; lines: fitted. "
         "The reference's noise is subtracted.</p>";
}

/// Of the first seed, whose end the pictures show.
const StudyPoint* pictured(const SettingResult& setting) {
  return setting.runs.empty() ? nullptr : &setting.runs.front().points.back();
}

std::string picturesTitle(const StudyResult& result) {
  double least = 0.0, most = 0.0;
  for (const SettingResult& setting : result.settings) {
    if (const StudyPoint* end = pictured(setting)) {
      least = least > 0.0 ? std::min(least, end->seconds) : end->seconds;
      most = std::max(most, end->seconds);
    }
  }
  return most <= (1.0 + kEqualTime) * least ? fmt::format("Pictures at equal time ({:.3g} s)", most)
                                            : "Pictures at the end of the first seed";
}

/// The colours of the difference pictures, as a gradient of CSS.
std::string colourScale() {
  constexpr int kSteps = 8;
  std::string stops;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec3d c = 255.0 * magma(static_cast<double>(i) / kSteps);
    stops += fmt::format(", rgb({:.0f} {:.0f} {:.0f})", c.x, c.y, c.z);
  }
  return fmt::format("0.1 % <span class=scale style='background: linear-gradient(to right{})'></span> 100 %",
                     stops);
}

std::string pictures(const fs::path& folder, const StudyFacts& facts, const StudyResult& result) {
  std::string images, differences;
  for (std::size_t i = 0; i < result.settings.size(); ++i) {
    const SettingResult& setting = result.settings[i];
    const StudyPoint* end = pictured(setting);
    if (setting.picture.pixelCount() == 0 || end == nullptr)
      continue;
    const fs::path picture = folder / fmt::format("picture-{}.png", i + 1);
    const fs::path difference = folder / fmt::format("difference-{}.png", i + 1);
    writeImage(picture, setting.picture, facts.display, {});
    writeImage(difference, differencePicture(setting.picture, result.referenceImage), {0.0, Tonemap::None},
               {});
    const std::string caption =
        fmt::format("{}: {:.3g} s, {} samples a pixel", setting.setting.name, end->seconds, end->frames);
    images += html::figure("picture", picture, caption);
    differences += html::figure(
        "difference", difference,
        fmt::format("{}: {}", setting.setting.name, percent(std::sqrt(std::max(end->error.relMse, 0.0)))));
  }
  const fs::path reference = folder / "reference.png";
  writeImage(reference, result.referenceImage, facts.display, {});
  images += html::figure("picture", reference, "reference");
  return fmt::format("<h3>{}</h3>"
                     "<div class=pair><img alt='left'><img alt='right'>"
                     "<input type=range min=0 max=100 value=50 aria-label='where the pictures meet'></div>"
                     "<p class=choose>left <select aria-label=left></select> right <select "
                     "aria-label=right></select></p>"
                     "<div class=row>{}</div>"
                     "<h3>Differences from the reference</h3><div class=row>{}</div>"
                     "<p class=note>Relative, logarithmic: {} (magma).</p>",
                     picturesTitle(result), images, differences, colourScale());
}

std::string overhead(const StudyResult& result) {
  const double rendering = result.renderSeconds + result.referenceSeconds;
  return rendering > 0.0 ? fmt::format(" ({} of the rendering)", percent(result.overheadSeconds / rendering))
                         : std::string();
}

std::string header(const StudyFacts& facts, const StudyResult& result,
                   const std::vector<SettingSummary>& summaries) {
  const std::size_t seeds = result.settings.empty() ? 0 : result.settings.front().runs.size();
  std::string html = fmt::format(
      "<h2>{}</h2><p>{}×{} pixels, {} settings, {} seeds. {}Reference: {} (own relative error {}).</p>"
      "<p class=note>Rendering {:.3g} s, reference {:.3g} s; not in the clock: loading {:.2g} s, compiling "
      "{:.2g} s, measuring and taking turns {:.2g} s{}.</p>",
      html::escaped(facts.scene), result.referenceImage.width, result.referenceImage.height,
      result.settings.size(), seeds,
      facts.kinds.empty() ? "" : "Light paths of kind " + html::escaped(facts.kinds) + " alone. ",
      html::escaped(facts.referenceName),
      result.referenceNoiseIsKnown ? percent(std::sqrt(result.referenceNoise.relMse)) : "not known",
      result.renderSeconds, result.referenceSeconds, facts.loadSeconds, facts.compileSeconds,
      result.overheadSeconds, overhead(result));
  for (const auto& remark : remarks(result, summaries))
    html += "<p class=remark>" + html::escaped(remark) + "</p>";
  return html;
}

/// The scenes beside each other; empty for a single one.
std::string overview(const std::vector<StudySection>& sections) {
  if (sections.size() < 2)
    return {};
  std::vector<std::vector<std::string>> rows;
  for (const StudySection& section : sections)
    std::ranges::move(overviewRows(section.facts.scene, section.result, summarise(section.result)),
                      std::back_inserter(rows));
  return html::table(overviewHead(), rows);
}

} // namespace

std::string studySection(const fs::path& folder, const StudySection& section) {
  const StudyResult& result = section.result;
  const auto summaries = summarise(result);
  drawPlots(folder, summaries);
  std::string html = "<section class=study>" + header(section.facts, result, summaries) + plots(folder);
  if (result.ablation)
    html += ablationTable(summaries);
  html += mainTables(result, summaries);
  if (!result.ablation)
    html += biasTable(result, summaries);
  return html + pictures(folder, section.facts, result) + "</section>\n";
}

void writeReport(const fs::path& folder, const std::vector<StudySection>& sections) {
  film::writeTextFile(folder / "results.json", resultsJson(sections));
  std::string body;
  for (const StudySection& section : sections) {
    const fs::path own = sections.size() > 1 ? folder / section.facts.folder : folder;
    fs::create_directories(own);
    film::writeTextFile(own / "results.csv", resultsCsv(section.result));
    body += studySection(own, section);
  }
  const StudyFacts& facts = sections.front().facts;
  const std::string head =
      fmt::format("<h1>What accuracy costs</h1><p><code>{}</code></p><p class=note>{}</p>",
                  html::escaped(facts.command), html::escaped(facts.device));
  film::writeTextFile(folder / "report.html", html::page("vkpt study", kReportStyle,
                                                         head + overview(sections) + body, kReportScript));
}

} // namespace vkpt
