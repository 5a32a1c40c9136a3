#include "scene/load.h"

#include "scene/assemble.h"
#include "scene/sources.h"

namespace vkpt {

Scene loadScene(std::span<const fs::path> files, SceneReport& report) {
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
