#pragma once
// The command line of vkpt assignment.

#include "app/assignment_pictures.h"
#include "app/options.h"

namespace vkpt {

struct AssignmentOptions {
  Sheet sheet = Sheet::A;
  fs::path folder;
  bool quick = false;
  double quality = 1.0;          ///< multiplies samples and times
  std::vector<std::string> only; ///< names of pictures; empty: all, and the experiments
  bool force = false;
  std::string device;
  bool validation = false;
  bool progress = true;
  LogLevel log = LogLevel::Normal;
  std::string command; ///< as it was typed
  [[nodiscard]] bool wants(std::string_view name) const;
};

/// Nothing where help or the list was asked for, and printed. Throws UsageError.
std::optional<AssignmentOptions> parseAssignmentOptions(const std::vector<std::string>& arguments);

} // namespace vkpt
