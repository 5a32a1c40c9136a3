#pragma once
// What a run says at its end: the summary, the JSON figures and the images' metadata, all from one struct.

#include "app/options.h"
#include "film/film.h"
#include "film/tail.h"
#include "render/render_loop.h"

namespace vkpt {

struct RunReport {
  std::string scene;
  int width = 0;
  int height = 0;
  RenderResult result;
  std::optional<double> targetError; ///< that was asked for
  struct Seconds {
    double load = 0.0;
    double build = 0.0;
    double compile = 0.0;
    double render = 0.0;
    double output = 0.0;
  } seconds;
  RunCounters counters;
  std::vector<Fault> faults;          ///< the first of them
  std::vector<std::string> arguments; ///< of the command, for a line that replays one
  FilmStatistics film;
  std::optional<TailEstimate> tail;
  std::vector<std::string> effects;
  std::string device;
  std::string sampler;
  std::uint32_t seed = 0;
  std::uint64_t deviceBytes = 0;
  SceneReport sceneReport;       ///< conventions of the file's framework that were applied, and warnings
  std::vector<std::string> bias; ///< options that bias the result, empty by default
};

/// The summary for stdout: time, samples, rays, error, why it stopped, where the images are.
std::string summaryText(const RunReport& report, const std::vector<fs::path>& outputs);
/// interface.md's `--stats` schema 1.
std::string statsJson(const RunReport& report);
/// The same facts, a key for each leaf ("faults.nonFinite"); an error that is not known is left out.
Metadata imageMetadata(const RunReport& report);
/// Why the errors are not to be trusted, in one line; empty where they are.
std::string tailWarning(const RunReport& report);
/// Every fault by its cause, in one line.
std::string faultText(const RunCounters& counters);

} // namespace vkpt
