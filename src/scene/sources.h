#pragma once
// Scene texts, from the file system or built into the binary: from here on both go the same way.

#include "core/error.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt {

/// A text file of assets/, embedded by embed_assets.cmake.
struct EmbeddedAsset {
  std::string_view name;
  std::string_view text;
};
std::span<const EmbeddedAsset> embeddedAssets();

struct SceneText {
  std::string name;     ///< for messages: the path as the user gave it, or "builtin:CornellBox.obj"
  std::string fileName; ///< the last part alone
  std::string text;
  fs::path folder;       ///< where the files it names are, unless embedded
  bool embedded = false; ///< the files it names are embedded too
};

/// What is loaded when no scene is named: the first of the built-in ones.
std::vector<SceneText> openDefaultScene();

/// Reads one scene, a file or a built-in one. Appends to `notes` where a built-in file stands in for one that
/// is not there. Throws SceneError.
std::vector<SceneText> openScene(const fs::path& scene, std::vector<std::string>& notes);

/// Where a file that `from` names is, unless `from` is embedded.
fs::path pathBeside(const SceneText& from, const std::string& fileName);

/// A file that `from` names; nothing where there is none that can be read.
std::optional<SceneText> openBeside(const SceneText& from, const std::string& fileName);

} // namespace vkpt
