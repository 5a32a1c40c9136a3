#include "scene/sources.h"

#include "scene/load.h"
#include "scene/names.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vkpt {

namespace {

constexpr std::array kBuiltins{
    BuiltinScene{"cornell", "the Cornell box with the short and the tall block"},
    BuiltinScene{"cornell-spheres", "the Cornell box with a silver sphere left and a glass sphere right"},
};

/// In the order of kBuiltins.
const std::array<std::vector<std::string_view>, kBuiltins.size()>& builtinFiles() {
  static const std::array<std::vector<std::string_view>, kBuiltins.size()> files{{
      {"CornellBox.obj", "CornellBlocks.obj"},
      {"CornellBox.obj", "CornellLeftSphere.obj", "CornellRightSphere.obj"},
  }};
  return files;
}

const EmbeddedAsset* findAsset(std::string_view name) {
  const auto assets = embeddedAssets();
  const auto found = std::ranges::find(assets, name, &EmbeddedAsset::name);
  return found == assets.end() ? nullptr : &*found;
}

SceneText embeddedText(const EmbeddedAsset& asset) {
  return {fmt::format("builtin:{}", asset.name), std::string(asset.name), std::string(asset.text), {}, true};
}

std::vector<SceneText> openBuiltin(std::size_t index) {
  std::vector<SceneText> texts;
  for (const std::string_view file : builtinFiles()[index]) {
    texts.push_back(embeddedText(*findAsset(file)));
  }
  return texts;
}

std::string whatThereIs(std::string_view typed) {
  std::vector<std::string_view> scenes;
  std::vector<std::string_view> candidates;
  for (const BuiltinScene& scene : kBuiltins) {
    scenes.push_back(scene.name);
    candidates.push_back(scene.name);
  }
  for (const EmbeddedAsset& asset : embeddedAssets()) {
    if (asset.name.ends_with(".obj")) {
      candidates.push_back(asset.name);
    }
  }
  return fmt::format("a scene is an .obj file or a Nori .xml file, or one of the built-in {}{}",
                     fmt::join(scenes, ", "), didYouMean(typed, candidates));
}

std::optional<std::string> readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::vector<char> chunk(1U << 16U);
  while (file.is_open() && file.read(chunk.data(), std::ssize(chunk)).gcount() > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
  }
  text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
  return file.bad() || !file.is_open() ? std::nullopt : std::optional(std::move(text));
}

SceneText openFile(const fs::path& path, fs::file_type type) {
  const std::string name = path.string();
  if (type == fs::file_type::directory) {
    throw SceneError({name}, "is a folder; name an .obj file in it, or an .xml file");
  }
  if (type != fs::file_type::regular && type != fs::file_type::fifo) {
    throw SceneError({name}, "is no regular file; " + whatThereIs({}));
  }
  const std::string extension = lowerCase(path.extension().string());
  if (extension != ".obj" && extension != ".xml") {
    throw SceneError({name}, fmt::format("unknown extension '{}'; {}", path.extension().string(),
                                         whatThereIs(path.filename().string())));
  }
  auto text = readText(path);
  if (!text) {
    throw SceneError({name}, "cannot be read; check its permissions");
  }
  return {name, path.filename().string(), std::move(*text), path.parent_path(), false};
}

} // namespace

std::span<const BuiltinScene> builtinScenes() { return kBuiltins; }

std::vector<SceneText> openDefaultScene() { return openBuiltin(0); }

std::vector<SceneText> openScene(const fs::path& scene, std::vector<std::string>& notes) {
  const std::string name = scene.string();
  std::error_code error;
  const fs::file_type type = fs::status(scene, error).type();
  const bool found = type != fs::file_type::not_found && type != fs::file_type::none;
  const auto builtin = std::ranges::find(kBuiltins, name, &BuiltinScene::name);
  if (builtin != kBuiltins.end() && (!found || type == fs::file_type::directory)) {
    return openBuiltin(static_cast<std::size_t>(builtin - kBuiltins.begin()));
  }
  if (found) {
    return {openFile(scene, type)};
  }
  const EmbeddedAsset* asset = findAsset(name);
  if (asset != nullptr && name.ends_with(".obj")) {
    notes.push_back(fmt::format("{}: built in", name));
    return {embeddedText(*asset)};
  }
  if (error && error != std::errc::no_such_file_or_directory) {
    throw SceneError({name}, fmt::format("cannot be read ({}); {}", error.message(), whatThereIs(name)));
  }
  throw SceneError({name}, "no such file; " + whatThereIs(name));
}

fs::path pathBeside(const SceneText& from, const std::string& fileName) {
  return (from.folder / fileName).lexically_normal();
}

std::optional<SceneText> openBeside(const SceneText& from, const std::string& fileName) {
  if (from.embedded) {
    const EmbeddedAsset* asset = findAsset(fileName);
    return asset == nullptr ? std::nullopt : std::optional(embeddedText(*asset));
  }
  const fs::path path = pathBeside(from, fileName);
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return std::nullopt;
  }
  auto text = readText(path);
  if (!text) {
    return std::nullopt;
  }
  return SceneText{path.string(), path.filename().string(), std::move(*text), path.parent_path(), false};
}

} // namespace vkpt
