#include "app/run_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vkpt {
namespace {

nlohmann::ordered_json rgb(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Whole frames as whole numbers: 64, not 64.0.
nlohmann::ordered_json frameNumber(double frames) {
  if (frames == std::floor(frames))
    return static_cast<std::uint64_t>(frames);
  return frames;
}

std::string faultText(const RunCounters& c) {
  return fmt::format("{} non-finite samples, {} cut traversals, {} stack overflows, {} invalid densities",
                     c.nonFinite, c.cutTraversal, c.stackOverflow, c.invalidPdf);
}

} // namespace

std::string summaryText(const RunReport& r, const std::vector<fs::path>& outputs) {
  std::string text;
  const auto line = [&](const std::string& s) { text += s + "\n"; };
  for (const auto& note : r.notes)
    line(note);
  line(fmt::format("{}, {}x{}, {:.6g} samples per pixel in {:.2f} s ({:.2f} Msamples/s), stopped by: {}",
                   r.scene, r.width, r.height, r.result.frames, r.seconds.render,
                   static_cast<double>(r.counters.samples) / std::max(r.seconds.render, 1e-9) * 1e-6,
                   stopReasonName(r.result.stop)));
  line(fmt::format("rays: {} closest hit, {} shadow; load {:.2f} s, build {:.2f} s, compile {:.2f} s",
                   r.counters.raysClosest, r.counters.raysShadow, r.seconds.load, r.seconds.build,
                   r.seconds.compile));
  line(fmt::format("mean radiance {:.5g} {:.5g} {:.5g}, estimated relative error {:.2f} %", r.film.mean.x,
                   r.film.mean.y, r.film.mean.z, r.film.relativeError * 100.0));
  if (r.counters.cappedPaths > 0)
    line(fmt::format("{} paths ended by the cap on trapped paths", r.counters.cappedPaths));
  if (!r.bias.empty())
    line(fmt::format("biased by: {}", fmt::join(r.bias, ", ")));
  if (r.counters.faults() > 0)
    line("FAULTS: " + faultText(r.counters));
  for (const auto& path : outputs)
    line("written: " + path.string());
  return text;
}

std::string statsJson(const RunReport& r) {
  nlohmann::ordered_json j;
  j["schema"] = 1;
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
  j["samples"] = r.counters.samples;
  j["rays"] = {{"closest", r.counters.raysClosest}, {"shadow", r.counters.raysShadow}};
  j["samplesPerSecond"] = static_cast<double>(r.counters.samples) / std::max(r.seconds.render, 1e-9);
  j["error"] = {{"relative", r.film.relativeError}, {"standardError", rgb(r.film.standardError)}};
  j["mean"] = rgb(r.film.mean);
  j["effects"] = r.effects;
  j["device"] = r.device;
  j["deviceBytes"] = r.deviceBytes;
  j["seed"] = r.seed;
  j["bias"] = r.bias;
  j["notes"] = r.notes;
  j["dispatches"] = r.counters.dispatches;
  j["cappedPaths"] = r.counters.cappedPaths;
  j["carriedPaths"] = r.counters.carriedPaths;
  j["faults"] = {{"nonFinite", r.counters.nonFinite},
                 {"cutTraversal", r.counters.cutTraversal},
                 {"stackOverflow", r.counters.stackOverflow},
                 {"invalidPdf", r.counters.invalidPdf}};
  return j.dump(2) + "\n";
}

Metadata imageMetadata(const RunReport& r) {
  Metadata m;
  m["version"] = std::string(VKPT_VERSION);
  m["scene"] = r.scene;
  m["frames"] = r.result.frames;
  m["stop"] = std::string(stopReasonName(r.result.stop));
  m["seconds"] = r.seconds.render;
  m["samples"] = static_cast<std::int64_t>(r.counters.samples);
  m["relativeError"] = r.film.relativeError;
  m["effects"] = fmt::format("{}", fmt::join(r.effects, " "));
  m["device"] = r.device;
  m["seed"] = static_cast<std::int64_t>(r.seed);
  m["bias"] = fmt::format("{}", fmt::join(r.bias, ", "));
  m["cappedPaths"] = static_cast<std::int64_t>(r.counters.cappedPaths);
  m["faults"] = static_cast<std::int64_t>(r.counters.faults());
  return m;
}

} // namespace vkpt
