#include "app/options.h"

#include "scene/load.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <iostream>

namespace vkpt {
namespace {

constexpr const char* kUsage =
    "vkpt renders scenes by path tracing in Vulkan compute, on a GPU or in software.\n"
    "Usage: vkpt [SCENE...] [options]     render; without SCENE the built-in Cornell box\n"
    "       vkpt devices                  the Vulkan devices, and which one would be used\n";
constexpr const char* kExamples =
    "Examples:\n"
    "  vkpt --frames 64                                    the Cornell box into vkpt.png\n"
    "  vkpt cornell-spheres --time 10 -o spheres.exr       ten seconds of caustics, linear, with standard "
    "errors\n"
    "  vkpt CornellBox.obj CornellBlocks.obj --size 256x256 --light bsdf\n"
    "  vkpt room.obj --look-at 0,1,4,0,1,0 --fov 60 --background 0.5,0.7,1\n"
    "Exit codes: 0 done, 1 usage, 2 scene, 3 device, 5 faults were counted, 75 interrupted (what was done is "
    "written)";

/// Comma-separated finite numbers, exactly `count` of them.
std::vector<double> parseNumbers(const std::string& option, const std::string& text, std::size_t count,
                                 const char* right) {
  std::vector<double> values;
  const char* p = text.data();
  const char* const end = p + text.size();
  while (p <= end) {
    double v = 0.0;
    const auto [next, error] = std::from_chars(p, end, v);
    if (error != std::errc{} || !std::isfinite(v) || (next != end && *next != ','))
      break;
    values.push_back(v);
    p = next + 1;
  }
  if (values.size() != count || p != end + 1) {
    throw UsageError(fmt::format("{} '{}': expected {}", option, text, right));
  }
  return values;
}

Vec3d vector3(const std::vector<double>& v, std::size_t at = 0) { return {v[at], v[at + 1], v[at + 2]}; }

std::pair<int, int> parseSize(const std::string& text) {
  int width = 0;
  int height = 0;
  const char* const end = text.data() + text.size();
  const auto w = std::from_chars(text.data(), end, width);
  if (w.ec == std::errc{} && w.ptr != end && *w.ptr == 'x') {
    const auto h = std::from_chars(w.ptr + 1, end, height);
    if (h.ec == std::errc{} && h.ptr == end && width > 0 && height > 0)
      return {width, height};
  }
  throw UsageError(fmt::format("--size '{}': expected WxH with both above 0, e.g. 512x512", text));
}

std::uint32_t parseBounces(const std::string& text) {
  if (text == "inf")
    return kUnlimitedBounces;
  std::uint32_t n = 0;
  const char* const end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, n);
  if (error != std::errc{} || next != end || n == kUnlimitedBounces) {
    throw UsageError(fmt::format("--max-bounces '{}': expected a whole number, or inf", text));
  }
  return n;
}

/// Text options that are parsed after CLI11 has collected them.
struct RawOptions {
  std::string size, lookAt, up, background, bounces = "inf";
  bool quiet = false, verbose = false, noProgress = false, listScenes = false;
};

void addStopOptions(CLI::App& app, RenderOptions& o) {
  app.add_option("--frames", o.job.frames,
                 "iterations: samples for every pixel (default: the scene's own, else 64)")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{0xFFFFFFFF}));
  app.add_option("--time", o.job.seconds, "stop after this many seconds of rendering")
      ->check(CLI::PositiveNumber);
  app.add_option("--target-error", o.job.targetError, "stop when the image's relative error is at most this")
      ->check(CLI::PositiveNumber);
  app.add_option("--batch", o.job.batch, "frames per dispatch; never changes the image")
      ->check(CLI::Range(1U, shared::kSamplesPerGroup))
      ->capture_default_str();
  app.add_option("--tile-blocks", o.job.tileBlocks,
                 "8x8 blocks per dispatch, 0: by measured time; never changes the image")
      ->check(CLI::Range(0U, 16384U))
      ->capture_default_str();
}

void addEstimatorOptions(CLI::App& app, RenderOptions& o, RawOptions& raw) {
  static const std::map<std::string, LightStrategy> kLight{{"nee", LightStrategy::Nee},
                                                           {"bsdf", LightStrategy::Bsdf}};
  static const std::map<std::string, RouletteMode> kRoulette{{"albedo", RouletteMode::Albedo},
                                                             {"throughput", RouletteMode::Throughput}};
  app.add_option("--light", o.estimator.light,
                 "how emitters are found: nee (light sampling) or bsdf (default nee)")
      ->transform(CLI::Transformer(kLight, CLI::ignore_case).description("nee|bsdf"));
  app.add_option("--max-bounces", raw.bounces, "0: emitted light only, 1: + direct light, ...; or inf")
      ->capture_default_str();
  app.add_option("--roulette", o.estimator.roulette,
                 "survive with the surface's albedo or the path's throughput "
                 "(default throughput)")
      ->transform(CLI::Transformer(kRoulette, CLI::ignore_case).description("albedo|throughput"));
  app.add_option(
      "--roulette-after", o.estimator.rouletteAfter,
      "first bounce after whose direct light roulette may end a path (default: albedo 1, throughput 3)");
  app.add_option("--seed", o.seed, "of the random numbers")->capture_default_str();
  app.add_option("--background", raw.background, "radiance R,G,B of rays that leave the scene (default 0)");
}

void addImageOptions(CLI::App& app, RenderOptions& o, RawOptions& raw) {
  static const std::map<std::string, Tonemap> kTonemap{
      {"none", Tonemap::None}, {"srgb", Tonemap::Srgb}, {"aces", Tonemap::Aces}};
  app.add_option("--size", raw.size, "image size WxH (default: the scene's, else 512x512)");
  app.add_option("-o,--output", o.outputs,
                 "image file: .png, .exr, .hdr or .pfm; may be repeated (default vkpt.png)")
      ->expected(1)
      ->take_all();
  app.add_option("--exposure", o.display.exposureStops, "in stops, for .png only")->capture_default_str();
  app.add_option("--tonemap", o.display.tonemap, "for .png only (default srgb)")
      ->transform(CLI::Transformer(kTonemap, CLI::ignore_case).description("none|srgb|aces"));
  app.add_option("--look-at", raw.lookAt,
                 "camera EX,EY,EZ,TX,TY,TZ: eye and target (default: fitted to the scene)");
  app.add_option("--up", raw.up, "camera's up vector X,Y,Z");
  app.add_option("--fov", o.fovDegrees, "horizontal field of view, degrees");
}

void addRunOptions(CLI::App& app, RenderOptions& o, RawOptions& raw) {
  app.add_option("--device", o.device,
                 "Vulkan device, by index or part of its name (default: a discrete GPU, else any)");
  app.add_option("--stats", o.stats, "write the run's figures as JSON");
  app.add_flag("--strict", o.strict, "warnings about a scene are errors");
  app.add_flag("--validation", o.validation, "turn the Vulkan validation layer on; a message is an error");
  app.add_flag("--quiet", raw.quiet, "errors only");
  app.add_flag("--verbose", raw.verbose, "say more, e.g. every option as it was expanded");
  app.add_flag("--no-progress", raw.noProgress, "no progress line");
  app.add_flag("--list-scenes", raw.listScenes, "list the built-in scenes");
}

void interpret(const RawOptions& raw, RenderOptions& o) {
  if (!raw.size.empty())
    o.size = parseSize(raw.size);
  o.estimator.maxBounces = parseBounces(raw.bounces);
  if (!raw.lookAt.empty()) {
    const auto v = parseNumbers("--look-at", raw.lookAt, 6, "six numbers EX,EY,EZ,TX,TY,TZ");
    o.lookAt = {vector3(v), vector3(v, 3)};
  }
  if (!raw.up.empty())
    o.up = vector3(parseNumbers("--up", raw.up, 3, "three numbers X,Y,Z"));
  if (!raw.background.empty()) {
    const auto v = parseNumbers("--background", raw.background, 3, "three radiances R,G,B");
    o.background = Vec3f(vector3(v));
    if (v[0] < 0.0 || v[1] < 0.0 || v[2] < 0.0) {
      throw UsageError(fmt::format("--background '{}': a radiance can't be negative", raw.background));
    }
  }
  if (!std::isfinite(o.display.exposureStops))
    throw UsageError("--exposure: expected a finite number of stops");
  if (raw.quiet && raw.verbose)
    throw UsageError("--quiet and --verbose contradict each other");
  o.log = raw.quiet ? LogLevel::Quiet : raw.verbose ? LogLevel::Verbose : LogLevel::Normal;
  o.progress = !raw.noProgress && !raw.quiet;
  if (o.outputs.empty())
    o.outputs.emplace_back("vkpt.png");
}

/// CLI11's messages may have several lines; ours has one.
std::string oneLine(std::string text) {
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text + "; see vkpt --help";
}

} // namespace

CommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  CommandLine line;
  RenderOptions& o = line.render;
  RawOptions raw;
  CLI::App app(kUsage, "vkpt");
  app.footer(kExamples);
  app.set_version_flag("--version", std::string("vkpt ") + VKPT_VERSION);
  app.add_option("SCENE", o.scenes, ".obj files, together one scene; or a built-in scene's name");
  addStopOptions(app, o);
  addImageOptions(app, o, raw);
  addEstimatorOptions(app, o, raw);
  addRunOptions(app, o, raw);
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    app.parse(reversed);
  } catch (const CLI::Success& e) { // --help, --version
    app.exit(e, std::cout, std::cerr);
    line.command = Command::Exit;
    return line;
  } catch (const CLI::ParseError& e) {
    throw UsageError(oneLine(e.what()));
  }
  interpret(raw, o);
  if (raw.listScenes)
    line.command = Command::ListScenes;
  if (o.scenes.size() == 1 && o.scenes.front() == "devices")
    line.command = Command::Devices;
  return line;
}

std::vector<std::string> describeOptions(const RenderOptions& o) {
  const auto bounces =
      o.estimator.maxBounces == kUnlimitedBounces ? "inf" : std::to_string(o.estimator.maxBounces);
  std::vector<std::string> lines{
      fmt::format("--light {}", o.estimator.light == LightStrategy::Nee ? "nee" : "bsdf"),
      "--max-bounces " + bounces,
      fmt::format("--roulette {} --roulette-after {}",
                  o.estimator.roulette == RouletteMode::Albedo ? "albedo" : "throughput",
                  o.estimator.effectiveRouletteAfter()),
      fmt::format("--seed {} --batch {} --tile-blocks {}", o.seed, o.job.batch, o.job.tileBlocks),
      fmt::format("--exposure {}", o.display.exposureStops)};
  if (o.job.frames)
    lines.push_back(fmt::format("--frames {}", *o.job.frames));
  if (o.job.seconds)
    lines.push_back(fmt::format("--time {}", *o.job.seconds));
  if (o.job.targetError)
    lines.push_back(fmt::format("--target-error {}", *o.job.targetError));
  for (const auto& path : o.outputs)
    lines.push_back("--output " + path.string());
  return lines;
}

} // namespace vkpt
