#pragma once
// Loads scene files (and scenes built into the binary) into one Scene.

#include "scene/scene.h"

#include <span>
#include <string_view>

namespace vkpt {

/// Loads all `files` as ONE scene: .obj files, or a single Nori .xml file. A name that is no file but a
/// built-in scene (`builtinScenes()`) loads that; an empty span loads the built-in Cornell box with blocks.
/// Throws SceneError (file:line, what, what would be right). Warnings go into `report`; the caller decides
/// whether they are errors (`--strict`).
Scene loadScene(std::span<const fs::path> files, SceneReport& report);

struct BuiltinScene {
  std::string_view name;        ///< "cornell"
  std::string_view description; ///< one line
};
/// The scenes that are embedded in the binary, in the order in which `--list-scenes` shows them.
std::span<const BuiltinScene> builtinScenes();

} // namespace vkpt
