#include "app/option_parser.h"

#include "core/error.h"
#include "scene/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace vkpt {
namespace {

std::string unknownOption(const CLI::App& app, const std::string& help) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const auto& name : option->get_lnames())
      names.push_back("--" + name);
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto unknown = app.remaining();
  const std::string first = unknown.empty() ? "" : unknown.front();
  return fmt::format("{}: unknown option{}; see {}", first, didYouMean(first, views), help);
}

/// CLI11's messages may have several lines; ours has one.
std::string oneLine(std::string text, const std::string& help) {
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return fmt::format("{}; see {}", text, help);
}

} // namespace

CLI::Option* addValue(CLI::App& app, const std::string& name, const char* kind,
                      const std::function<void(const std::string&)>& handle, const std::string& description) {
  return app.add_option_function<std::string>(name, handle, description)->type_name(kind);
}

bool parseArguments(CLI::App& app, const std::vector<std::string>& arguments, const std::string& help) {
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    app.parse(reversed);
  } catch (const CLI::Success& e) { // --help, --version
    app.exit(e, std::cout, std::cerr);
    return false;
  } catch (const CLI::ExtrasError&) {
    throw UsageError(unknownOption(app, help));
  } catch (const CLI::ParseError& e) {
    throw UsageError(oneLine(e.what(), help));
  }
  return true;
}

} // namespace vkpt
