#include "app/run_report.h"

#include "core/duration.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace vkpt {
namespace {

constexpr double kFarExtrapolation = 10.0; // times what was rendered: worth a word

nlohmann::ordered_json rgb(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Whole frames as whole numbers: 64, not 64.0.
nlohmann::ordered_json frameNumber(double frames) {
  if (frames == std::floor(frames))
    return static_cast<std::uint64_t>(frames);
  return frames;
}

/// One sample a pixel tells nothing of the error, which the film gives as infinite.
std::string errorText(const FilmStatistics& film) {
  if (!std::isfinite(film.relativeError))
    return "relative error not known (fewer than 2 samples a pixel)";
  return fmt::format("estimated relative error {:.2f} % (95 % confident: below {:.2f} %)",
                     film.relativeError * 100.0, film.relativeErrorUpper * 100.0);
}

std::string lawText(const CostOfError& cost) {
  return cost.measured ? fmt::format("measured: the error falls with frames to the {:.2f}", cost.exponent)
                       : std::string("by the law of independent samples: fewer than 3 looks at the error");
}

/// What more would cost; empty where that is not known.
std::string costText(const RunReport& r) {
  const auto cost = costOfError(0.5, r.result.looks, r.seconds.render);
  if (!cost)
    return {};
  return fmt::format("the error is {:.2g} %; half of it would take another {} ({})",
                     r.film.relativeError * 100.0, durationText(cost->more), lawText(*cost));
}

/// When a target that was missed would be met; empty where there was none, or it was met. The rule that stops
/// looks at the upper bound.
std::string targetText(const RunReport& r) {
  if (!r.targetError || !(r.film.relativeErrorUpper > *r.targetError))
    return {};
  const std::string missed = fmt::format("the target, {:.3g} %, was not reached", *r.targetError * 100.0);
  const auto cost = costOfError(*r.targetError / r.film.relativeErrorUpper, r.result.looks, r.seconds.render);
  if (!cost)
    return missed + "; when it would be is not known, since the error does not fall yet";
  const double times = cost->more / std::max(r.seconds.render, 1e-9);
  return fmt::format("{}; that would take another {}{}", missed, durationText(cost->more),
                     times > kFarExtrapolation
                         ? fmt::format(", an extrapolation over {:.2g} times this run", times)
                         : std::string());
}

double samplesPerSecond(const RunReport& r) {
  return static_cast<double>(r.film.samples) / std::max(r.seconds.render, 1e-9);
}

/// Numbers that are not finite become null.
nlohmann::ordered_json statsOf(const RunReport& r) {
  nlohmann::ordered_json j;
  j["schema"] = 1;
  j["version"] = VKPT_VERSION;
  j["scene"] = r.scene;
  j["width"] = r.width;
  j["height"] = r.height;
  j["frames"] = frameNumber(r.result.frames);
  j["stop"] = stopReasonName(r.result.stop);
  j["seconds"] = {{"load", r.seconds.load},
                  {"build", r.seconds.build},
                  {"compile", r.seconds.compile},
                  {"render", r.seconds.render},
                  {"output", r.seconds.output}};
  j["samples"] = r.film.samples;
  j["rays"] = {{"closest", r.counters.raysClosest}, {"shadow", r.counters.raysShadow}};
  j["samplesPerSecond"] = samplesPerSecond(r);
  j["error"] = {{"relative", r.film.relativeError},
                {"relativeUpper95", r.film.relativeErrorUpper},
                {"standardError", rgb(r.film.standardError)}};
  if (r.tail)
    j["error"]["tailIndex"] = r.tail->index;
  j["error"]["trusted"] = !(r.tail && r.tail->heavy());
  j["mean"] = rgb(r.film.mean);
  j["effects"] = r.effects;
  j["device"] = r.device;
  j["deviceBytes"] = r.deviceBytes;
  j["sampler"] = r.sampler;
  j["seed"] = r.seed;
  j["bias"] = r.bias;
  j["notes"] = r.sceneReport.notes;
  j["warnings"] = r.sceneReport.warnings;
  j["droppedDegenerate"] = r.sceneReport.droppedDegenerate;
  j["droppedDuplicates"] = r.sceneReport.droppedDuplicates;
  j["dispatches"] = r.counters.dispatches;
  j["cappedPaths"] = r.counters.cappedPaths;
  j["carriedPaths"] = r.counters.carriedPaths;
  j["faults"] = {{"nonFinite", r.counters.nonFinite},
                 {"cutTraversal", r.counters.cutTraversal},
                 {"stackOverflow", r.counters.stackOverflow},
                 {"invalidPdf", r.counters.invalidPdf}};
  return j;
}

Metadata::mapped_type metadataValue(const nlohmann::ordered_json& value) {
  if (value.is_boolean())
    return std::int64_t{value.get<bool>() ? 1 : 0};
  if (value.is_number_float())
    return value.get<double>();
  if (value.is_number())
    return value.get<std::int64_t>();
  if (value.is_string())
    return value.get<std::string>();
  std::string list; // numbers, or lines of text
  for (const auto& entry : value)
    list += fmt::format("{}{}",
                        list.empty()        ? ""
                        : entry.is_string() ? "\n"
                                            : " ",
                        entry.is_string() ? entry.get<std::string>() : entry.dump());
  return list;
}

bool isKnown(const nlohmann::ordered_json& value) {
  if (value.is_array())
    return std::ranges::all_of(value, isKnown);
  return !value.is_null() && !(value.is_number_float() && !std::isfinite(value.get<double>()));
}

void flatten(const std::string& prefix, const nlohmann::ordered_json& object, Metadata& metadata) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object())
      flatten(prefix + key + ".", value, metadata);
    else if (isKnown(value))
      metadata[prefix + key] = metadataValue(value);
  }
}

} // namespace

std::string faultText(const RunCounters& c) {
  return fmt::format("{} non-finite samples, {} cut traversals, {} stack overflows, {} invalid densities",
                     c.nonFinite, c.cutTraversal, c.stackOverflow, c.invalidPdf);
}

std::string tailWarning(const RunReport& r) {
  if (!r.tail || !r.tail->heavy())
    return {};
  return fmt::format(
      "the standard error is not to be trusted: the samples' tail falls with power {:.2f} (Hill), "
      "below 2 their variance is infinite or their brightest are still too few",
      r.tail->index);
}

namespace {

/// A word as a shell reads it.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain = "+,-./0123456789:=@_";
  const auto plain = [&](unsigned char c) {
    return std::isalnum(c) != 0 || kPlain.find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, plain))
    return word;
  std::string text(1, '\'');
  for (const char c : word)
    text.append(c == '\'' ? "'\\''" : std::string(1, c));
  text.push_back('\'');
  return text;
}

std::string replayCommand(const RunReport& r) {
  std::string text = "vkpt";
  for (const auto& word : r.arguments)
    text.append(" ").append(quoted(word));
  const Fault& f = r.faults.front();
  return fmt::format("{} --pixel {},{} --sample {}", text, f.x, f.y, f.sample);
}

std::string_view causeName(FaultCause cause) {
  switch (cause) {
  case FaultCause::NonFinite:
    return "nonFinite";
  case FaultCause::CutTraversal:
    return "cutTraversal";
  case FaultCause::InvalidPdf:
    return "invalidPdf";
  }
  return "";
}

nlohmann::ordered_json faultRecords(const RunReport& r) {
  auto list = nlohmann::ordered_json::array();
  for (const Fault& f : r.faults)
    list.push_back(
        {{"x", f.x}, {"y", f.y}, {"sample", f.sample}, {"bounce", f.bounce}, {"cause", causeName(f.cause)}});
  return list;
}

} // namespace

std::string summaryText(const RunReport& r, const std::vector<fs::path>& outputs) {
  std::string text;
  const auto line = [&](const std::string& s) { text += s + "\n"; };
  for (const auto& note : r.sceneReport.notes)
    line(note);
  line(fmt::format("{}, {}x{}, {:.6g} samples per pixel in {:.2f} s ({:.2f} Msamples/s), stopped by: {}",
                   r.scene, r.width, r.height, r.result.frames, r.seconds.render, samplesPerSecond(r) * 1e-6,
                   stopReasonName(r.result.stop)));
  line(fmt::format("rays: {} closest hit, {} shadow; load {:.2f} s, build {:.2f} s, compile {:.2f} s",
                   r.counters.raysClosest, r.counters.raysShadow, r.seconds.load, r.seconds.build,
                   r.seconds.compile));
  line(fmt::format("mean radiance {:.5g} {:.5g} {:.5g}, {}", r.film.mean.x, r.film.mean.y, r.film.mean.z,
                   errorText(r.film)));
  if (const std::string cost = costText(r); !cost.empty())
    line(cost);
  if (const std::string target = targetText(r); !target.empty())
    line(target);
  if (const std::string warning = tailWarning(r); !warning.empty())
    line(warning);
  if (r.counters.cappedPaths > 0)
    line(fmt::format("{} paths ended by the cap on trapped paths", r.counters.cappedPaths));
  if (!r.bias.empty())
    line(fmt::format("biased by: {}", fmt::join(r.bias, ", ")));
  if (r.counters.faults() > 0)
    line("FAULTS: " + faultText(r.counters));
  if (!r.faults.empty())
    line("the first of them again, vertex by vertex: " + replayCommand(r));
  for (const auto& path : outputs)
    line("written: " + path.string());
  return text;
}

std::string statsJson(const RunReport& report) {
  auto stats = statsOf(report);
  if (!report.faults.empty())
    stats["faultRecords"] = faultRecords(report);
  return stats.dump(2) + "\n";
}

Metadata imageMetadata(const RunReport& report) {
  Metadata metadata;
  flatten("", statsOf(report), metadata);
  metadata.erase("schema");
  metadata.erase("seconds.output"); // not over yet
  return metadata;
}

} // namespace vkpt
