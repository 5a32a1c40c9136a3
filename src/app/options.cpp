#include "app/options.h"

#include "app/option_names.h"
#include "app/option_parser.h"
#include "app/option_values.h"
#include "scene/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

constexpr const char* kUsage =
    "vkpt renders scenes by path tracing in Vulkan compute, on a GPU or in software.\n"
    "Usage: vkpt [SCENE...] [options]     render; without SCENE the built-in Cornell box\n"
    "       vkpt view [SCENE...]          a progressive preview in a window; see vkpt view --help\n"
    "       vkpt explain [SCENE...]       which effects are compiled in, because of what, and what they "
    "take\n"
    "       vkpt devices                  the Vulkan devices, and which one would be used\n"
    "       vkpt selftest [FILE.xml]      the hard cases on this device, or a file's own tests; see vkpt "
    "selftest --help\n"
    "       vkpt study [SCENE...]         what accuracy costs in time, as a report; see vkpt study --help\n"
    "       vkpt assignment a|b           every deliverable of an assignment; see vkpt assignment --help\n"
    "       vkpt compare IMAGE REFERENCE  error metrics and a difference picture; see vkpt compare --help\n";
constexpr const char* kExamples =
    "Examples:\n"
    "  vkpt --frames 64                                    the Cornell box into vkpt.png\n"
    "  vkpt cornell-spheres --time 10 -o spheres.exr       ten seconds of caustics, linear, with standard "
    "errors\n"
    "  vkpt CornellBox.obj CornellBlocks.obj --size 256x256 --light bsdf\n"
    "  vkpt cbox.xml --roulette constant=0.4 --time 60 -o cbox.exr\n"
    "  vkpt cornell-spheres --paths caustic --split 2\n"
    "  vkpt room.obj --look-at 0,1,4,0,1,0 --fov 60 --background 0.5,0.7,1\n"
    "Exit codes: 0 done, 1 usage, 2 scene, 3 device, 4 a comparison or self-test failed, 5 faults were "
    "counted, 75 "
    "interrupted (what was done is "
    "written)";

constexpr std::uint64_t kLargest32 = 0xFFFFFFFF;
constexpr double kLargestRadiance = 1e12; // products of a few stay in the range of float, as in MTL files

Vec3d vector3(const std::vector<double>& v, std::size_t at = 0) { return {v[at], v[at + 1], v[at + 2]}; }

void addStopOptions(CLI::App& app, RenderOptions& o) {
  addValue(
      app, "--frames", "N",
      [&o](const auto& text) { o.job.frames = parseWhole("--frames", text, 1, kLargest32); },
      "iterations: samples for every pixel (default: the scene's own, else 64)");
  addValue(
      app, "--time", "S",
      [&o](const auto& text) { o.job.seconds = parsePositive("--time", text, "seconds, above 0"); },
      "stop after this many seconds of rendering");
  addValue(
      app, "--target-error", "E",
      [&o](const auto& text) {
        o.job.targetError = parsePositive("--target-error", text, "a relative error above 0, e.g. 0.02");
      },
      "stop when the image's relative error is at most this");
  addValue(
      app, "--batch", "N",
      [&o](const auto& text) {
        o.job.batch = static_cast<std::uint32_t>(parseWhole("--batch", text, 1, shared::kSamplesPerGroup));
      },
      "frames per dispatch, 1 to 16 (default 16); never changes the image");
  addValue(
      app, "--tile-blocks", "N",
      [&o](const auto& text) {
        o.job.tileBlocks = static_cast<std::uint32_t>(parseWhole("--tile-blocks", text, 0, kMostTileBlocks));
      },
      "8x8 blocks per dispatch, 0: by measured time (default 0); never changes the image");
}

/// albedo, throughput or constant=Q.
void parseRoulette(const std::string& text, EstimatorSettings& e) {
  constexpr std::string_view kConstant = "constant=";
  if (text.starts_with(kConstant)) {
    constexpr const char* kRight = "constant=Q with a probability Q above 0, at most 1";
    const double q = parseFinite("--roulette", std::string_view(text).substr(kConstant.size()), kRight);
    if (!(q > 0.0 && q <= 1.0))
      refuseValue("--roulette", text, kRight);
    e.roulette = RouletteMode::Constant;
    e.termination = q;
    return;
  }
  const auto found = std::ranges::find(kRouletteNames, text);
  if (found == kRouletteNames.end() || text == "constant")
    refuseValue("--roulette", text, "albedo, throughput or constant=Q");
  e.roulette = static_cast<RouletteMode>(found - kRouletteNames.begin());
}

std::uint32_t parsePathKinds(const std::string& text) {
  std::uint32_t kinds = 0;
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    kinds |= 1U << parseName("--paths", rest.substr(0, comma), kKindNames);
    more = comma != std::string_view::npos;
    if (more)
      rest.remove_prefix(comma + 1);
  }
  return kinds;
}

void addLightOptions(CLI::App& app, RenderOptions& o) {
  EstimatorSettings& e = o.estimator;
  addValue(
      app, "--light", "nee|bsdf|mis",
      [&o](const auto& text) {
        o.light = static_cast<LightStrategy>(parseName("--light", text, kLightNames));
      },
      "how emitters are found: light sampling, BSDF sampling or both weighted (default mis)");
  addValue(
      app, "--light-samples", "N",
      [&e](const auto& text) {
        e.lightSamples =
            static_cast<std::uint32_t>(parseWhole("--light-samples", text, 1, shared::kMaxLightSamples));
      },
      "shadow rays at a surface point, 1 to 16 (default 1)");
  addValue(
      app, "--light-selection", "auto|power|tree",
      [&e](const auto& text) {
        e.lightSelection =
            static_cast<LightSelection>(parseName("--light-selection", text, kLightSelectionNames));
      },
      "one of several lights: by its power, or by a tree of what lights may bring to a place (default auto: "
      "the tree where they are spread out)");
  addValue(
      app, "--paths", "LIST", [&o](const auto& text) { o.pathKinds = parsePathKinds(text); },
      "only these kinds of light path, e.g. caustic,indirect (default all); biases the image");
  addValue(
      app, "--output-paths", "PREFIX",
      [&o](const auto& text) {
        if (text.empty())
          refuseValue("--output-paths", text, "the start of file names, e.g. box");
        o.kindPrefix = text;
        o.estimator.kindImages = true;
      },
      "an image of each kind of light path beside the whole: PREFIX-caustic.png, ...");
}

void addEstimatorOptions(CLI::App& app, RenderOptions& o) {
  EstimatorSettings& e = o.estimator;
  addLightOptions(app, o);
  addValue(
      app, "--max-bounces", "N|inf",
      [&o](const auto& text) {
        o.maxBounces =
            text == "inf"
                ? kUnlimitedBounces
                : static_cast<std::uint32_t>(parseWhole("--max-bounces", text, 0, kUnlimitedBounces - 1));
      },
      "0: emitted light only, 1: + direct light, ... (default inf); biases the image");
  addValue(
      app, "--roulette", "albedo|throughput|constant=Q", [&e](const auto& text) { parseRoulette(text, e); },
      "survive with the surface's albedo or the path's throughput, or end with probability Q (default "
      "throughput)");
  addValue(
      app, "--roulette-after", "N",
      [&e](const auto& text) {
        e.rouletteAfter = static_cast<std::uint32_t>(parseWhole("--roulette-after", text, 0, kLargest32));
      },
      "first bounce after whose direct light roulette may end a path (default: albedo 1, throughput 3, "
      "constant 2)");
  addValue(
      app, "--split", "N",
      [&e](const auto& text) {
        e.splitDepth = static_cast<std::uint32_t>(parseWhole("--split", text, 0, shared::kMaxSplitDepth));
      },
      "at glass follow both branches up to this trace depth, 0 to 16 (default 0)");
  addValue(
      app, "--sampler", "independent|sobol",
      [&e](const auto& text) {
        e.sampler = static_cast<Sampler>(parseName("--sampler", text, kSamplerNames));
      },
      "random numbers: independent, or Owen-scrambled Sobol' points (default sobol)");
  addValue(
      app, "--light-tracing", "auto|on|off",
      [&e](const auto& text) {
        e.lightTracing = static_cast<LightTracing>(parseName("--light-tracing", text, kLightTracingNames));
      },
      "paths from the lights as well, for caustics: where the scene has them, or not (default auto)");
  addValue(
      app, "--guiding", "auto|off",
      [&e](const auto& text) {
        e.guiding = static_cast<Guiding>(parseName("--guiding", text, kGuidingNames));
      },
      "behind specular surfaces, directions from where light was seen to come from: with paths from the "
      "lights, or "
      "not (default auto)");
  addValue(
      app, "--specular-samples", "N",
      [&e](const auto& text) {
        e.specularSamples = static_cast<std::uint32_t>(
            parseWhole("--specular-samples", text, 1, shared::kMaxSpecularSamples));
      },
      "paths of a sample whose first surface is a mirror, smooth metal or glass, 1 to 16 (default 4)");
  addValue(
      app, "--path-reuse", "N",
      [&e](const auto& text) {
        constexpr const char* kRight = "1, 4, 16 or 64 pixels";
        const auto pixels = parseWhole("--path-reuse", text, 1, shared::kBlockPixels);
        if (pixels != 1 && pixels != 4 && pixels != 16 && pixels != 64)
          refuseValue("--path-reuse", text, kRight);
        e.pathReuse = static_cast<std::uint32_t>(pixels);
      },
      "neighbouring pixels that share their paths' second halves, 1, 4, 16 or 64: less noise, which the "
      "pixels share, too (default 1)");
  addValue(
      app, "--pilot", "S",
      [&o](const auto& text) { o.pilotSeconds = parsePositive("--pilot", text, "seconds, above 0"); },
      "before the render, try S seconds each in a small image what is worth most: light tracing, choice of "
      "lights, shared paths, paths at specular surfaces, guiding, splitting; options that are given stay");
  addValue(
      app, "--seed", "N",
      [&o](const auto& text) {
        o.seed = static_cast<std::uint32_t>(parseWhole("--seed", text, 0, kLargest32));
      },
      "of the random numbers (default 0)");
  addValue(
      app, "--background", "R,G,B",
      [&o](const auto& text) {
        constexpr const char* kRight = "three radiances R,G,B from 0 to 1e12";
        const auto v = parseList("--background", text, 3, kRight);
        if (std::ranges::any_of(v, [](double c) { return c < 0.0 || c > kLargestRadiance; }))
          refuseValue("--background", text, kRight);
        o.background = Vec3f(vector3(v));
      },
      "radiance of rays that leave the scene (default 0)");
  addValue(
      app, "--environment", "FILE",
      [&o](const auto& text) {
        const fs::path path(text);
        const std::string extension = lowerCase(path.extension().string());
        if (extension != ".hdr" && extension != ".exr" && extension != ".pfm")
          refuseValue("--environment", text, "an image in .hdr, .exr or .pfm");
        o.environment = path;
      },
      "light from all around: an image in latitude and longitude, +y up, -z in its middle (default: the "
      "scene's)");
}

void addImageOptions(CLI::App& app, RenderOptions& o) {
  addValue(
      app, "--size", "WxH", [&o](const auto& text) { o.size = parseSize("--size", text); },
      "image size (default: the scene's, else 512x512)");
  app.add_option("-o,--output", o.outputs,
                 "image file: .png, .exr, .hdr or .pfm; may be repeated (default vkpt.png)")
      ->expected(1)
      ->take_all()
      ->type_name("FILE");
  addValue(
      app, "--exposure", "STOPS",
      [&o](const auto& text) {
        o.display.exposureStops = parseFinite("--exposure", text, "a finite number of stops, e.g. -1.5");
      },
      "for .png only (default 0)");
  addValue(
      app, "--tonemap", "none|srgb|aces",
      [&o](const auto& text) {
        o.display.tonemap = static_cast<Tonemap>(parseName("--tonemap", text, kTonemapNames));
      },
      "for .png only (default srgb)");
  addValue(
      app, "--filter", "box|tent|gaussian|mitchell",
      [&o](const auto& text) {
        o.filter = static_cast<PixelFilter::Shape>(parseName("--filter", text, kFilterNames));
      },
      "reconstruction filter (default: the scene's, else box)");
}

void addCameraOptions(CLI::App& app, RenderOptions& o) {
  addValue(
      app, "--look-at", "EX,EY,EZ,TX,TY,TZ",
      [&o](const auto& text) {
        constexpr const char* kRight = "eye and target, two different points, EX,EY,EZ,TX,TY,TZ";
        const auto v = parseList("--look-at", text, 6, kRight);
        if (vector3(v) == vector3(v, 3))
          refuseValue("--look-at", text, kRight);
        o.lookAt = {vector3(v), vector3(v, 3)};
      },
      "camera: eye and target (default: fitted to the scene)");
  addValue(
      app, "--up", "X,Y,Z",
      [&o](const auto& text) {
        constexpr const char* kRight = "a direction X,Y,Z other than 0,0,0";
        o.up = vector3(parseList("--up", text, 3, kRight));
        if (o.up == Vec3d(0.0))
          refuseValue("--up", text, kRight);
      },
      "the camera's up vector (default 0,1,0)");
  addValue(
      app, "--fov", "DEG",
      [&o](const auto& text) {
        constexpr const char* kRight = "degrees above 0 and below 180";
        o.fovDegrees = parsePositive("--fov", text, kRight);
        if (!(*o.fovDegrees < 180.0))
          refuseValue("--fov", text, kRight);
      },
      "horizontal field of view");
}

struct Flags {
  bool quiet = false, verbose = false, noProgress = false, listScenes = false;
};

void addRunOptions(CLI::App& app, RenderOptions& o, Flags& flags) {
  app.add_option("--device", o.device,
                 "Vulkan device, by index or part of its name (default: a discrete GPU, else any)")
      ->type_name("NAME|INDEX");
  addValue(
      app, "--stats", "FILE.json",
      [&o](const auto& text) {
        o.stats = text;
        if (o.stats.extension() != ".json") // else `--stats scene.obj` would write over the scene
          refuseValue("--stats", text, "a name that ends in .json");
      },
      "write the run's figures");
  addValue(
      app, "--effects", "auto|all|auto,-NAME",
      [&o](const auto& text) { o.effects = parseEffectsOption(text); },
      "compile in what the scene calls for, everything (the same image), or leave out NAME, which biases the "
      "image (default auto); NAME as vkpt explain tells it");
  app.add_flag("--measure", o.measure, "with explain: measure what each effect costs on this device");
  app.add_flag("--json", o.json, "with explain: JSON in place of the table");
  addValue(
      app, "--pixel", "X,Y",
      [&o](const auto& text) {
        constexpr const char* kRight = "a column and a row X,Y from 0, row 0 at the top";
        const auto v = parseList("--pixel", text, 2, kRight);
        if (std::ranges::any_of(v, [](double c) { return !(c >= 0.0 && c < 1e9) || c != std::floor(c); }))
          refuseValue("--pixel", text, kRight);
        o.pixel = {static_cast<int>(v[0]), static_cast<int>(v[1])};
      },
      "replay one path of this pixel and print it vertex by vertex, in float and in double");
  addValue(
      app, "--sample", "I",
      [&o](const auto& text) { o.sample = parseWhole("--sample", text, 0, 0xFFFFFFFFFFFF); },
      "with --pixel: which of its samples, from 0 (default 0)");
  app.add_flag("--strict", o.strict, "warnings about a scene are errors");
  app.add_flag("--validation", o.validation, "turn the Vulkan validation layer on; a message is an error");
  app.add_flag("--quiet", flags.quiet, "errors only");
  app.add_flag("--verbose", flags.verbose, "say more, e.g. every option as it was expanded");
  app.add_flag("--no-progress", flags.noProgress, "no progress line");
  app.add_flag("--list-scenes", flags.listScenes, "list the built-in scenes");
}

/// What holds between options, once all are known.
void interpret(const Flags& flags, CommandLine& line) {
  RenderOptions& o = line.render;
  if (flags.quiet && flags.verbose)
    throw UsageError("--quiet and --verbose contradict each other; give one of them");
  o.log = flags.quiet ? LogLevel::Quiet : flags.verbose ? LogLevel::Verbose : LogLevel::Normal;
  o.progress = !flags.noProgress && !flags.quiet;
  if (o.outputs.empty())
    o.outputs.emplace_back("vkpt.png");
  if (o.pixel)
    line.command = Command::Replay;
  if (flags.listScenes)
    line.command = Command::ListScenes;
  if (!o.scenes.empty() && o.scenes.front() == "explain") {
    o.scenes.erase(o.scenes.begin());
    line.command = Command::Explain;
  } else if (o.measure || o.json) {
    throw UsageError(fmt::format("{}: for vkpt explain alone", o.measure ? "--measure" : "--json"));
  }
  if (o.pilotSeconds && line.command != Command::Render)
    throw UsageError("--pilot: for a render alone; give the options that its pilot has chosen");
  if (!o.scenes.empty() && o.scenes.front() == "devices") {
    if (o.scenes.size() > 1)
      throw UsageError(fmt::format("devices '{}': the command takes no scene", o.scenes[1].string()));
    line.command = Command::Devices;
  }
}

} // namespace

CommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  CommandLine line;
  RenderOptions& o = line.render;
  Flags flags;
  CLI::App app(kUsage, "vkpt");
  app.footer(kExamples);
  app.set_version_flag("--version", std::string("vkpt ") + VKPT_VERSION);
  app.add_option("SCENE", o.scenes,
                 ".obj files, together one scene; a Nori .xml file; or a built-in scene's name")
      ->type_name("");
  addStopOptions(app, o);
  addImageOptions(app, o);
  addCameraOptions(app, o);
  addEstimatorOptions(app, o);
  addRunOptions(app, o, flags);
  if (!parseArguments(app, arguments, "vkpt --help")) {
    line.command = Command::Exit;
    return line;
  }
  o.arguments = arguments;
  interpret(flags, line);
  return line;
}

} // namespace vkpt
