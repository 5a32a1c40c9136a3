#pragma once
// Opens a page that a command has written in headless Chromium, as its user would.

#include "cli/command.h"

namespace vkpt::test {

/// Chromium's full path; empty where it is not installed (cmake/setup.sh test does).
std::string chromium();

struct OpenedPage {
  std::vector<std::string> console; ///< what the browser said of the page: errors, all of it
  /// images: [{alt, width, colours}], width 0: broken; colours: different ones among the pixels.
  /// sliders: [{clip, names, left, right}] after each was moved to 25 %: the clip path, the pictures to
  /// choose from, and whether the shown ones are those that were chosen.
  nlohmann::json facts;
};
OpenedPage openPage(const fs::path& html);

} // namespace vkpt::test
