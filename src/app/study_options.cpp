#include "app/study_options.h"

#include "app/expanded_options.h"
#include "app/option_parser.h"
#include "app/option_values.h"
#include "scene/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace vkpt {
namespace {

constexpr double kDefaultSeconds =
    6.0; // four settings, three seeds and their reference: within three minutes
constexpr std::uint32_t kMostSeeds = 1000;
constexpr std::size_t kMostVariants = 64;

/// Options of render that change how the image is estimated, or how fast.
constexpr std::array<std::string_view, 18> kCanVary{
    "sampler",    "light",         "light-samples",    "max-bounces",     "roulette",   "roulette-after",
    "split",      "paths",         "filter",           "batch",           "effects",    "tile-blocks",
    "background", "light-tracing", "specular-samples", "light-selection", "path-reuse", "guiding"};

struct Vary {
  std::string option;
  std::vector<std::string> values;
};

/// "roulette=constant=1.0,constant=0.7": the option ends at the first '='.
Vary parseVary(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    refuseValue("--vary", text, "OPTION=A,B,..., e.g. split=0,1,2");
  Vary vary{text.substr(0, equals), {}};
  if (std::ranges::find(kCanVary, vary.option) == kCanVary.end())
    refuseValue("--vary", text, fmt::format("an option that can vary: {}", fmt::join(kCanVary, ", ")));
  std::string_view rest = std::string_view(text).substr(equals + 1);
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    vary.values.emplace_back(rest.substr(0, comma));
    more = comma != std::string_view::npos;
    if (more)
      rest.remove_prefix(comma + 1);
  }
  return vary;
}

/// Every combination, the last option's values turning fastest.
std::vector<std::vector<std::string>> combinations(const std::vector<Vary>& varied) {
  std::vector<std::vector<std::string>> all{{}};
  for (const Vary& vary : varied) {
    std::vector<std::vector<std::string>> longer;
    for (const auto& values : all) {
      for (const auto& value : vary.values) {
        longer.push_back(values);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
    if (all.size() > kMostVariants)
      throw UsageError(fmt::format("--vary: more than {} settings; give fewer values", kMostVariants));
  }
  return all;
}

RenderOptions parseRest(const std::vector<std::string>& arguments) {
  const CommandLine line = parseCommandLine(arguments);
  const RenderOptions& o = line.render;
  if (line.command != Command::Render)
    throw UsageError("study: only the options of render go with it; see vkpt study --help");
  const auto refuse = [](bool given, const char* option) {
    if (given)
      throw UsageError(fmt::format("{}: not an option of study; see vkpt study --help", option));
  };
  refuse(!o.stats.empty(), "--stats");
  refuse(!o.kindPrefix.empty(), "--output-paths");
  refuse(o.pilotSeconds.has_value(), "--pilot");
  return o;
}

/// .obj files are together one scene, every other name is a scene of its own.
std::vector<std::vector<fs::path>> scenesOf(const std::vector<fs::path>& names) {
  std::vector<std::vector<fs::path>> scenes;
  std::optional<std::size_t> objects;
  for (const fs::path& name : names) {
    const bool isObject = lowerCase(name.extension().string()) == ".obj";
    if (isObject && objects) {
      scenes[*objects].push_back(name);
      continue;
    }
    if (isObject)
      objects = scenes.size();
    scenes.push_back({name});
  }
  if (scenes.empty())
    scenes.emplace_back(); // the default
  return scenes;
}

std::vector<StudyVariant> variantsOf(const std::vector<Vary>& varied, const std::vector<std::string>& rest) {
  std::vector<StudyVariant> variants;
  for (const auto& values : combinations(varied)) {
    std::vector<std::string> arguments = rest, names;
    for (std::size_t i = 0; i < values.size(); ++i) {
      arguments.insert(arguments.end(), {"--" + varied[i].option, values[i]});
      names.push_back(varied[i].option + "=" + values[i]);
    }
    variants.push_back(
        {names.empty() ? "as given" : fmt::format("{}", fmt::join(names, ", ")), parseRest(arguments)});
  }
  return variants;
}

void addOptions(CLI::App& app, StudyOptions& o, std::vector<Vary>& varied) {
  app.add_option_function<std::vector<std::string>>(
         "--vary",
         [&varied](const auto& texts) {
           for (const auto& text : texts)
             varied.push_back(parseVary(text));
         },
         fmt::format("compare settings, several times for all combinations; OPTION: {}",
                     fmt::join(kCanVary, ", ")))
      ->expected(1)
      ->take_all()
      ->type_name("OPTION=A,B,...");
  app.add_flag("--ablate", o.ablate, "leave out each kind of light path and each kind of surface in turn");
  addValue(
      app, "--class", "KIND",
      [&o](const auto& text) {
        std::vector<std::string_view> names;
        for (std::uint32_t i = 0; i < kPathKindCount; ++i)
          names.push_back(pathKindName(static_cast<PathKind>(i)));
        o.pathKinds = 1U << parseName("--class", text, names);
        o.kindName = text;
      },
      "render and judge one kind of light path alone, e.g. caustic");
  addValue(
      app, "--reference", "FILE", [&o](const auto& text) { o.reference = text; },
      "an image for the truth: .exr (best with standard errors), .hdr, .pfm (default: rendered first)");
  addValue(
      app, "--seeds", "N",
      [&o](const auto& text) {
        o.seeds = static_cast<std::uint32_t>(parseWhole("--seeds", text, 1, kMostSeeds));
      },
      "runs of each setting (default 3)");
  addValue(
      app, "--time", "S",
      [&o](const auto& text) { o.seconds = parsePositive("--time", text, "seconds, above 0"); },
      fmt::format("of rendering, for each setting and seed (default {:g}); the reference takes ten times it",
                  kDefaultSeconds));
  addValue(
      app, "-o,--output", "DIR", [&o](const auto& text) { o.folder = text; },
      "the report's folder (default vkpt-study)");
  app.add_flag("--force", o.force, "write into a folder that has files in it");
}

} // namespace

std::optional<StudyOptions> parseStudyOptions(const std::vector<std::string>& arguments) {
  StudyOptions o;
  std::vector<Vary> varied;
  CLI::App app("Error against time, as a report: every setting for the same time, in turns, against a "
               "reference. .obj files are together one scene; built-in names and .xml files are one "
               "each.\nUsage: vkpt study [SCENE...] [options] [options of render]",
               "vkpt study");
  app.footer(
      "Options of render hold for all settings, e.g. --frames N or --target-error E (measured) as further "
      "limits; --size has another default: the longer side 256 pixels, or the reference's.\n"
      "Examples:\n"
      "  vkpt study cornell-spheres --vary split=0,1,2,4 --class caustic\n"
      "  vkpt study q-scene.xml --vary roulette=constant=1.0,constant=0.7,constant=0.4,constant=0.1\n"
      "  vkpt study cornell-spheres --ablate -o what-matters\n"
      "  vkpt study cornell cornell-spheres cbox.xml --vary light=nee,mis --time 3 -o lights\n"
      "Exit codes: as of render");
  app.allow_extras();
  addOptions(app, o, varied);
  if (!parseArguments(app, arguments, "vkpt study --help"))
    return std::nullopt;
  const std::vector<std::string> rest = app.remaining();
  o.common = parseRest(rest);
  o.scenes = scenesOf(o.common.scenes);
  if (o.scenes.size() > 1 && !o.reference.empty())
    throw UsageError(fmt::format("--reference: for one scene, and there are {}", o.scenes.size()));
  o.variants = variantsOf(varied, rest);
  if (o.ablate && o.variants.size() > 1)
    throw UsageError("--ablate and --vary: give one of them");
  if (!o.seconds && !o.common.job.frames)
    o.seconds = kDefaultSeconds;
  o.command = fmt::format("vkpt study {}", fmt::join(arguments, " "));
  return o;
}

} // namespace vkpt
