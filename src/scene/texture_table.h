#pragma once
// The image files that materials name: each read once, and in the scene only if a material needs its texels.

#include "scene/mtl_reader.h"
#include "scene/scene.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vkpt {

class TextureTable {
public:
  /// What a file holds.
  struct Entry {
    Vec3f least{0.0F}; ///< per channel
    Vec3f most{0.0F};
    Texture texture;                    ///< without texels once it is in the scene
    std::optional<std::uint32_t> index; ///< in the scene
  };

  TextureTable(std::vector<Texture>& textures, SceneReport& report)
      : m_textures(textures), m_report(report) {}

  /// Null, with a warning the first time, where the file cannot be read. The pointer holds as long as the
  /// table.
  Entry* open(const MtlTexture& from);
  /// Its index in the scene, which it enters now if it has not before.
  std::uint32_t use(Entry& entry);

private:
  std::optional<Entry> read(const MtlTexture& from, const fs::path& path);

  std::vector<Texture>& m_textures;
  SceneReport& m_report;
  std::map<std::string, std::optional<Entry>> m_entries; ///< by the file's path; nothing: it cannot be read
};

} // namespace vkpt
