// The figures of a study for programs.

#include "study/study_report.h"

#include "core/duration.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

using Json = nlohmann::ordered_json;

/// A name as a field of CSV (RFC 4180).
std::string field(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

Json rgb(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json json(const std::optional<Spread>& s) {
  if (!s)
    return nullptr;
  return {{"median", s->median}, {"least", s->least}, {"most", s->most}};
}

Json json(const std::optional<Estimate>& e) {
  if (!e)
    return nullptr;
  return {{"value", e->value}, {"standardError", e->standardError ? Json(*e->standardError) : Json(nullptr)}};
}

Json json(const StudyRun& run) {
  Json points = Json::array();
  for (const StudyPoint& p : run.points) {
    points.push_back({{"frames", p.frames},
                      {"seconds", p.seconds},
                      {"mse", p.error.mse},
                      {"relMse", p.error.relMse},
                      {"predictedRelMse", p.predicted}});
  }
  return {{"seed", run.seed},
          {"mean", rgb(run.mean)},
          {"standardError", rgb(run.standardError)},
          {"points", std::move(points)}};
}

Json json(const SettingResult& setting, const SettingSummary& s, const std::vector<double>& levels) {
  Json times = Json::array();
  for (std::size_t i = 0; i < s.times.size(); ++i) {
    times.push_back({{"relativeError", levels[i]},
                     {"seconds", s.times[i] ? Json(s.times[i]->seconds) : Json(nullptr)},
                     {"extrapolated", s.times[i] && s.times[i]->extrapolated},
                     {"beyond", s.times[i] && s.times[i]->beyond}});
  }
  Json runs = Json::array();
  for (const StudyRun& run : setting.runs)
    runs.push_back(json(run));
  return {{"name", s.name},
          {"slopeOverTime", json(s.slopeOverTime)},
          {"slopeOverFrames", json(s.slopeOverFrames)},
          {"errorAtEqualTime", json(s.errorAtEqualTime)},
          {"errorAtEqualFrames", json(s.errorAtEqualFrames)},
          {"efficiency", s.efficiency ? Json(*s.efficiency) : Json(nullptr)},
          {"timeTo", std::move(times)},
          {"secondsPerFrame", s.secondsPerFrame},
          {"energy", json(std::optional(s.energy))},
          {"biased", s.isBiased()},
          {"bias", setting.setting.bias},
          {"lastingRelMse", json(s.lastingRelMse)},
          {"measuredOverPredicted", s.measuredOverPredicted ? Json(*s.measuredOverPredicted) : Json(nullptr)},
          {"compileSeconds", setting.compileSeconds},
          {"faults", setting.faults},
          {"runs", std::move(runs)}};
}

const char* stopName(StudyStop stop) {
  switch (stop) {
  case StudyStop::Limits:
    return "limits";
  case StudyStop::ReferenceNoise:
    return "referenceNoise";
  case StudyStop::User:
    return "user";
  }
  return "";
}

} // namespace

std::string resultsCsv(const StudyResult& result) {
  std::string text = "setting,seed,frames,seconds,mse,relMse,predictedRelMse\n";
  for (const SettingResult& setting : result.settings) {
    for (const StudyRun& run : setting.runs) {
      for (const StudyPoint& p : run.points)
        text += fmt::format("{},{},{},{},{},{},{}\n", field(setting.setting.name), run.seed, p.frames,
                            p.seconds, p.error.mse, p.error.relMse, p.predicted);
    }
  }
  return text;
}

namespace {

Json jsonOf(const StudySection& section) {
  const StudyFacts& facts = section.facts;
  const StudyResult& result = section.result;
  const auto summaries = summarise(result);
  Json settings = Json::array();
  for (std::size_t i = 0; i < summaries.size(); ++i)
    settings.push_back(json(result.settings[i], summaries[i], errorLevels(result)));
  Json j;
  j["schema"] = 1;
  j["command"] = facts.command;
  j["scene"] = facts.scene;
  j["device"] = facts.device;
  j["width"] = result.referenceImage.width;
  j["height"] = result.referenceImage.height;
  j["class"] = facts.kinds.empty() ? Json(nullptr) : Json(facts.kinds);
  j["stop"] = stopName(result.stop);
  j["equalSeconds"] = result.equalSeconds;
  j["equalFrames"] = result.equalFrames;
  j["seconds"] = {{"load", facts.loadSeconds},
                  {"compile", facts.compileSeconds},
                  {"reference", result.referenceSeconds},
                  {"render", result.renderSeconds},
                  {"measure", result.measuringSeconds},
                  {"overhead", result.overheadSeconds}};
  j["reference"] = {{"name", facts.referenceName},
                    {"frames", result.referenceFrames},
                    {"mean", rgb(result.referenceMean)},
                    {"noiseKnown", result.referenceNoiseIsKnown},
                    {"noiseRelMse", result.referenceNoise.relMse},
                    {"noiseMse", result.referenceNoise.mse}};
  j["remarks"] = remarks(result, summaries);
  j["settings"] = std::move(settings);
  return j;
}

/// A target that was set and that these runs did not reach, in a line; empty where there is none.
std::string missedTarget(const StudyResult& result, const SettingSummary& s) {
  if (!result.targetError)
    return {};
  const auto levels = errorLevels(result);
  const auto at = std::ranges::find(levels, *result.targetError) - levels.begin();
  const auto& time = s.times[static_cast<std::size_t>(at)];
  if (time && !time->extrapolated)
    return {};
  const std::string missed =
      fmt::format("{}: the target, {:.3g} %, was not reached", s.name, *result.targetError * 100.0);
  if (!time)
    return missed + (s.isBiased() ? ", and may never be: a bias remains." : ", and the error does not fall.");
  if (time->beyond)
    return missed + fmt::format("; it would take more than {}.", durationText(time->seconds));
  return missed + fmt::format("; by its slope it would be after about {}.", durationText(time->seconds));
}

} // namespace

std::string resultsJson(const std::vector<StudySection>& sections) {
  if (sections.size() == 1)
    return jsonOf(sections.front()).dump(2) + "\n";
  Json j;
  j["schema"] = 1;
  j["command"] = sections.front().facts.command;
  j["scenes"] = Json::array();
  for (const StudySection& section : sections)
    j["scenes"].push_back(jsonOf(section));
  return j.dump(2) + "\n";
}

std::vector<std::string> remarks(const StudyResult& result, const std::vector<SettingSummary>& summaries) {
  std::vector<std::string> lines;
  if (result.stop == StudyStop::User)
    lines.emplace_back("Interrupted: this is what was measured until then.");
  if (result.stop == StudyStop::ReferenceNoise)
    lines.push_back(
        fmt::format("Stopped at {:.3g} s: there the reference's own noise (relative error {:.3g} %) "
                    "came to a tenth of the squared error that was measured; it is subtracted.",
                    result.equalSeconds, std::sqrt(result.referenceNoise.relMse) * 100.0));
  if (!result.referenceNoiseIsKnown)
    lines.emplace_back("The reference tells no standard errors: its noise is taken for 0, and errors near it "
                       "are too large.");
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const SettingSummary& s = summaries[i];
    if (const std::string missed = missedTarget(result, s); !missed.empty())
      lines.push_back(missed);
    if (s.isBiased() && !(result.ablation && i > 0))
      lines.push_back(
          fmt::format("{}: its mean differs from the reference's by {:+.2f} % ± {:.2f} %: a bias, "
                      "which is part of its error.",
                      s.name, s.energy.value * 100.0, *s.energy.standardError * 100.0));
    if (result.settings[i].faults > 0)
      lines.push_back(fmt::format("{}: {} faults were counted; its image is wrong there.", s.name,
                                  result.settings[i].faults));
  }
  return lines;
}

} // namespace vkpt
