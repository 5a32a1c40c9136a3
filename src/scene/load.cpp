#include "scene/load.h"

#include "scene/assemble.h"
#include "scene/nori_scene.h"
#include "scene/sources.h"

#include <algorithm>

namespace vkpt {

Scene loadScene(std::span<const fs::path> files, SceneReport& report) {
  const auto nori = std::ranges::find_if(files, isNoriFile);
  if (nori != files.end()) {
    if (files.size() > 1) {
      throw SceneError({nori->string()}, "a Nori file is a whole scene; give it alone, without other files");
    }
    return loadNoriScene(openScene(*nori, report.notes).front(), report);
  }
  SceneAssembler assembler(report);
  if (files.empty()) {
    for (const SceneText& text : openDefaultScene()) {
      assembler.add(text);
    }
  }
  for (const fs::path& file : files) {
    for (const SceneText& text : openScene(file, report.notes)) {
      assembler.add(text);
    }
  }
  return assembler.finish();
}

} // namespace vkpt
