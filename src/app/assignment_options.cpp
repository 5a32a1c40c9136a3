#include "app/assignment_options.h"

#include "app/option_parser.h"
#include "app/option_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace vkpt {
namespace {

constexpr std::array<std::string_view, 2> kSheets{"a", "b"};

std::vector<std::string> namesIn(std::string_view text) {
  std::vector<std::string> names;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    names.emplace_back(text.substr(0, comma));
    more = comma != std::string_view::npos;
    if (more)
      text.remove_prefix(comma + 1);
  }
  return names;
}

void addOptions(CLI::App& app, AssignmentOptions& o, std::string& sheet, bool& list, bool& quiet,
                bool& noProgress) {
  app.add_option("SHEET", sheet, "a or b")->type_name("");
  addValue(
      app, "-o,--output", "DIR", [&o](const auto& text) { o.folder = text; },
      "where index.html and the pictures go (default assignment-a or assignment-b)");
  app.add_flag("--quick", o.quick, "small and noisy, in seconds: to see that all is there");
  addValue(
      app, "--quality", "Q",
      [&o](const auto& text) { o.quality = parsePositive("--quality", text, "a factor above 0, e.g. 0.25"); },
      "multiplies samples and times (default 1: about a quarter of an hour on two cores)");
  addValue(
      app, "--only", "NAMES", [&o](const auto& text) { o.only = namesIn(text); },
      "these pictures alone, without the experiments, e.g. a-blocks,a-spheres");
  app.add_flag("--list", list, "list the pictures: name, samples a pixel, arguments of vkpt");
  app.add_flag("--force", o.force, "write into a folder that has files in it");
  app.add_option("--device", o.device, "Vulkan device, by index or part of its name")
      ->type_name("NAME|INDEX");
  app.add_flag("--validation", o.validation, "turn the Vulkan validation layer on; a message is an error");
  app.add_flag("--quiet", quiet, "errors only");
  app.add_flag("--no-progress", noProgress, "no progress line");
}

void printList(Sheet sheet) {
  for (const AssignmentPicture& p : picturesOf(sheet))
    fmt::print("{:<21} {:>5}  {}\n", p.name, p.samples > 0 ? fmt::format("{}", p.samples) : "time",
               p.arguments);
}

} // namespace

bool AssignmentOptions::wants(std::string_view name) const {
  return only.empty() || std::ranges::find(only, name) != only.end();
}

std::optional<AssignmentOptions> parseAssignmentOptions(const std::vector<std::string>& arguments) {
  AssignmentOptions o;
  std::string sheet;
  bool list = false, quiet = false, noProgress = false;
  CLI::App app(
      "Every deliverable of an assignment: its pictures with times and samples, its experiments, and "
      "the answers to its questions, in DIR/index.html.\nUsage: vkpt assignment a|b [options]",
      "vkpt assignment");
  app.footer(
      "a: path tracing in the Cornell box, caustics, splitting. b: path integrals, Russian roulette, a "
      "scene of our own.\n"
      "Examples:\n"
      "  vkpt assignment a -o worksheet-5\n"
      "  vkpt assignment b --quick -o look\n"
      "  vkpt assignment a --only a-secondary-caustics --quality 4 -o print\n"
      "Ctrl-C writes the page with what is finished. Exit codes: as of render");
  addOptions(app, o, sheet, list, quiet, noProgress);
  if (!parseArguments(app, arguments, "vkpt assignment --help"))
    return std::nullopt;
  if (sheet.empty())
    throw UsageError("assignment: which one? vkpt assignment a, or vkpt assignment b");
  o.sheet = static_cast<Sheet>(parseName("assignment", sheet, kSheets));
  if (list) {
    printList(o.sheet);
    return std::nullopt;
  }
  std::vector<std::string_view> names;
  for (const AssignmentPicture& p : picturesOf(o.sheet))
    names.push_back(p.name);
  for (const std::string& name : o.only)
    parseName("--only", name, names);
  if (o.folder.empty())
    o.folder = "assignment-" + sheet;
  o.progress = !noProgress && !quiet;
  o.log = quiet ? LogLevel::Quiet : LogLevel::Normal;
  o.command = fmt::format("vkpt assignment {}", fmt::join(arguments, " "));
  return o;
}

} // namespace vkpt
