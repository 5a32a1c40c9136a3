#pragma once
// The command line of vkpt study: its own options, and those of render for every setting.

#include "app/options.h"

namespace vkpt {

/// One combination of the varied options.
struct StudyVariant {
  std::string name; ///< "split=2, light=nee"; "as given" where nothing varies
  RenderOptions options;
};

struct StudyOptions {
  std::vector<std::vector<fs::path>> scenes; ///< the files of each
  RenderOptions common;                      ///< what all settings share; its scenes are all files
  std::vector<StudyVariant> variants;
  std::optional<std::uint32_t> pathKinds; ///< --class: bit i: PathKind i
  std::string kindName;                   ///< of it
  fs::path reference;                     ///< an image; empty: rendered first
  bool ablate = false;
  std::uint32_t seeds = 3;
  std::optional<double> seconds; ///< of rendering, for a setting and a seed
  fs::path folder = "vkpt-study";
  bool force = false;  ///< write into a folder that has something in it
  std::string command; ///< as it was typed
};

/// Nothing where help was asked for, and printed. Throws UsageError.
std::optional<StudyOptions> parseStudyOptions(const std::vector<std::string>& arguments);

} // namespace vkpt
