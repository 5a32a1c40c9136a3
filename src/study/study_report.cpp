// report.html and the pictures that it holds.

#include "study/study_report.h"

#include "film/compare.h"
#include "film/file_io.h"
#include "study/report_style.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt {
namespace {

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
    case '&':
      html += "&amp;";
      break;
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    case '"':
      html += "&quot;";
      break;
    default:
      html += c;
    }
  }
  return html;
}

/// RFC 4648.
std::string base64(film::ByteView bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = (word << 8U) | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[(word >> (18U - 6U * k)) & 63U] : '=';
  }
  return text;
}

std::string dataUrl(const fs::path& file, const char* type) {
  return fmt::format("data:{};base64,{}", type, base64(film::readWholeFile(file)));
}

std::string percent(double share) { return fmt::format("{:.3g} %", share * 100.0); }

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
  return fmt::format("{}{:.3g} s", t->extrapolated ? "≈ " : "", t->seconds);
}

std::string energyCell(const SettingSummary& s) {
  return fmt::format("{:+.2f} %{}", s.energy.value * 100.0,
                     s.energy.standardError ? fmt::format(" ± {:.2f}", *s.energy.standardError * 100.0) : "");
}

std::string tableOf(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<table><tr>";
  for (const auto& h : head)
    html += "<th>" + h + "</th>";
  html += "</tr>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (const auto& value : row)
      html += "<td>" + value + "</td>";
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string mainTables(const StudyResult& result, const std::vector<SettingSummary>& summaries) {
  std::vector<std::vector<std::string>> equal, times, fits;
  for (const SettingSummary& s : summaries) {
    const std::string name = escaped(s.name);
    equal.push_back({name, cell(s.errorAtEqualTime), cell(s.errorAtEqualFrames),
                     s.efficiency ? fmt::format("{:.3g}", *s.efficiency) : "–",
                     fmt::format("{:.3g} ms", s.secondsPerFrame * 1e3)});
    times.push_back({name, cell(s.times[0]), cell(s.times[1]), cell(s.times[2])});
    fits.push_back({name, cell(s.slopeOverTime), cell(s.slopeOverFrames), energyCell(s)});
  }
  return "<h2>Equal time, equal samples</h2>" +
         tableOf({"setting", fmt::format("error after {:.3g} s", result.equalSeconds),
                  fmt::format("error after {} samples a pixel", result.equalFrames), "efficiency",
                  "time a sample"},
                 equal) +
         "<p class=note>Relative errors, medians over the seeds with the least and the largest. Efficiency: "
         "1 / "
         "(relMSE × time), over that of the first setting. Time a sample: one for every pixel.</p>"
         "<h2>Equal error</h2>" +
         tableOf({"setting", "time to 5 %", "to 2 %", "to 1 %"}, times) +
         "<p class=note>≈: beyond what was rendered, along the fitted slope.</p>"
         "<h2>Slopes and energy</h2>" +
         tableOf({"setting", "slope over time", "slope over samples", "energy against the reference"}, fits) +
         "<p class=note>Slopes of log relMSE, means over the seeds with their standard errors; independent "
         "samples have −1. Energy: of the image's mean; what a bias adds or takes.</p>";
}

/// What leaving something out saves and loses, against the first setting.
std::string ablationTable(const std::vector<SettingSummary>& summaries) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 1; i < summaries.size(); ++i) {
    const SettingSummary& s = summaries[i];
    const Ablation a = ablationOf(summaries.front(), s);
    rows.push_back({escaped(s.name), fmt::format("{:+.1f} %", a.timeSaved * 100.0),
                    fmt::format("{:+.2f} %", a.energyLost * 100.0), cell(s.errorAtEqualTime)});
  }
  return "<h2>What each part costs</h2>" +
         tableOf({"left out", "time saved", "energy lost", "error that stays"}, rows) +
         "<p class=note>Against the whole: time for a sample of every pixel, and the image's mean.</p>";
}

std::string plots(const fs::path& folder) {
  std::string html = "<h2>Error against time, and against samples</h2>";
  for (const char* name : {"error-time", "error-frames"}) {
    const fs::path file = folder / (std::string(name) + ".svg");
    if (fs::exists(file))
      html += fmt::format("<img class=plot alt='{}' src='{}'>\n", name, dataUrl(file, "image/svg+xml"));
  }
  return html +
         "<p class=note>Points: medians over the seeds, bars from the least to the largest; lines: fitted. "
         "The reference's noise is subtracted.</p>";
}

std::string figure(const char* kind, const fs::path& file, const std::string& caption) {
  return fmt::format("<figure class={}><img alt='' src='{}'><figcaption>{}</figcaption></figure>\n", kind,
                     dataUrl(file, "image/png"), escaped(caption));
}

std::string pictures(const fs::path& folder, const StudyFacts& facts, const StudyResult& result) {
  std::string images, differences;
  for (std::size_t i = 0; i < result.settings.size(); ++i) {
    const SettingResult& setting = result.settings[i];
    if (setting.picture.pixelCount() == 0)
      continue;
    const fs::path picture = folder / fmt::format("picture-{}.png", i + 1);
    const fs::path difference = folder / fmt::format("difference-{}.png", i + 1);
    writeImage(picture, setting.picture, facts.display, {});
    writeImage(difference, differencePicture(setting.picture, result.referenceImage), {0.0, Tonemap::None},
               {});
    images += figure("picture", picture, setting.setting.name);
    differences += figure("difference", difference, setting.setting.name);
  }
  const fs::path reference = folder / "reference.png";
  writeImage(reference, result.referenceImage, facts.display, {});
  images += figure("picture", reference, "reference");
  return fmt::format(
      "<h2>Pictures at equal time ({:.3g} s)</h2>"
      "<div class=pair><img id=under alt=''><img id=over alt=''>"
      "<input id=cut type=range min=0 max=100 value=50 aria-label='where the pictures meet'></div>"
      "<p class=choose>left <select id=left></select> right <select id=right></select></p>"
      "<div class=row>{}</div>"
      "<h2>Differences from the reference</h2><div class=row>{}</div>"
      "<p class=note>Relative, logarithmic: black 0.1 %, pale yellow 100 %.</p>",
      result.equalSeconds, images, differences);
}

std::string header(const StudyFacts& facts, const StudyResult& result,
                   const std::vector<SettingSummary>& summaries) {
  const std::size_t seeds = result.settings.empty() ? 0 : result.settings.front().runs.size();
  std::string html = fmt::format(
      "<h1>What accuracy costs: {}</h1><p><code>{}</code></p>"
      "<p>{}×{} pixels, {} settings, {} seeds; {}. {}Reference: {} (own relative error {}).</p>"
      "<p class=note>Rendering {:.3g} s, reference {:.3g} s; not in the clock: loading {:.2g} s, compiling "
      "{:.2g} s, "
      "measuring {:.2g} s.</p>",
      escaped(facts.scene), escaped(facts.command), result.referenceImage.width, result.referenceImage.height,
      result.settings.size(), seeds, escaped(facts.device),
      facts.kinds.empty() ? "" : "Light paths of kind " + escaped(facts.kinds) + " alone. ",
      escaped(facts.referenceName),
      result.referenceNoiseIsKnown ? percent(std::sqrt(result.referenceNoise.relMse)) : "not known",
      result.renderSeconds, result.referenceSeconds, facts.loadSeconds, facts.compileSeconds,
      result.measuringSeconds);
  for (const auto& remark : remarks(result, summaries))
    html += "<p class=remark>" + escaped(remark) + "</p>";
  return html;
}

} // namespace

void writeReport(const fs::path& folder, const StudyFacts& facts, const StudyResult& result) {
  const auto summaries = summarise(result);
  film::writeTextFile(folder / "results.csv", resultsCsv(result));
  film::writeTextFile(folder / "results.json", resultsJson(facts, result, summaries));
  drawPlots(folder, summaries);
  std::string html =
      "<!DOCTYPE html><html lang=en><head><meta charset=utf-8><title>vkpt study</title><style>";
  html += kReportStyle;
  html += "</style></head><body>" + header(facts, result, summaries) + plots(folder);
  if (result.ablation)
    html += ablationTable(summaries);
  html += mainTables(result, summaries) + pictures(folder, facts, result);
  html += std::string("<script>") + kReportScript + "</script></body></html>\n";
  film::writeTextFile(folder / "report.html", html);
}

} // namespace vkpt
