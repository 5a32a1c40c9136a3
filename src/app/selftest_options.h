#pragma once
// The command line of `vkpt selftest`.

#include "app/options.h"

namespace vkpt {

struct SelftestOptions {
  fs::path file;                  ///< of tests; empty: the hard cases
  std::vector<std::string> cases; ///< by name; empty: all
  bool list = false;
  bool json = false;
  fs::path keep; ///< folder for pictures; empty: none are kept
  RenderOptions common;
};

/// Empty where help was printed. Throws UsageError as parseCommandLine() does.
std::optional<SelftestOptions> parseSelftestOptions(const std::vector<std::string>& arguments);

} // namespace vkpt
