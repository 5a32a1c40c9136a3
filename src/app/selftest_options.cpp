#include "app/selftest_options.h"

#include "app/option_parser.h"
#include "scene/names.h"
#include "selftest/case.h"

#include <fmt/format.h>

#include <algorithm>

namespace vkpt {
namespace {

void addOptions(CLI::App& app, SelftestOptions& o) {
  app.add_option("--case", o.cases, "only this case, as --list names it; may be repeated")
      ->expected(1)
      ->take_all()
      ->type_name("NAME");
  app.add_flag("--list", o.list, "list the cases, and what holds in each");
  app.add_flag("--json", o.json, "JSON on stdout in place of the table");
  app.add_option("--keep", o.keep, "write the cases' pictures into this folder, as .exr and .png")
      ->type_name("DIR");
}

void checkCaseName(const std::string& name) {
  if (selftest::findCase(name) != nullptr)
    return;
  const std::vector<selftest::Case> cases = selftest::allCases();
  std::vector<std::string_view> names;
  for (const selftest::Case& c : cases)
    names.emplace_back(c.name);
  throw UsageError(
      fmt::format("--case {}: no such case{}; see vkpt selftest --list", name, didYouMean(name, names)));
}

} // namespace

std::optional<SelftestOptions> parseSelftestOptions(const std::vector<std::string>& arguments) {
  SelftestOptions o;
  CLI::App app("Without FILE: the hard cases, what breaks path tracers in float, on this device and driver. "
               "With FILE: "
               "the <test> blocks of a Nori file.\n"
               "Usage: vkpt selftest [FILE.xml] [options]",
               "vkpt selftest");
  app.footer("Also --device, --seed (other random numbers), --validation, --quiet, --verbose (every figure, "
             "not each case's closest), --no-progress; with FILE the estimator's options of render too.\n"
             "Examples:\n"
             "  vkpt selftest                                 on a new GPU or driver, first of all\n"
             "  vkpt selftest --list\n"
             "  vkpt selftest --case d4-slab --verbose --keep pictures\n"
             "  vkpt selftest --json > selftest.json\n"
             "  vkpt selftest assets/tests/furnace.xml\n"
             "Exit codes: 0 all passed, 1 usage, 2 the file, 3 the device, 4 a test failed, 75 interrupted");
  app.allow_extras();
  addOptions(app, o);
  if (!parseArguments(app, arguments, "vkpt selftest --help"))
    return std::nullopt;
  const CommandLine rest = parseCommandLine(app.remaining());
  if (rest.command != Command::Render)
    throw UsageError("selftest: an option of another command; see vkpt selftest --help");
  o.common = rest.render;
  if (o.common.scenes.size() > 1)
    throw UsageError(
        "selftest: give one file of tests, as in vkpt selftest FILE.xml, or none for the hard cases");
  if (!o.common.scenes.empty()) {
    o.file = o.common.scenes.front();
    if (!o.cases.empty() || o.list || o.json || !o.keep.empty())
      throw UsageError("selftest: --case, --list, --json and --keep go with the hard cases, not with a file");
  }
  std::ranges::for_each(o.cases, checkCaseName);
  return o;
}

} // namespace vkpt
