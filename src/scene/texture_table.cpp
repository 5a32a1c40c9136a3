#include "scene/texture_table.h"

#include "scene/names.h"
#include "scene/texture_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace vkpt {

namespace {

/// Some modellers write backslashes.
fs::path pathOf(const MtlTexture& from) {
  const fs::path path = (from.folder / from.file).lexically_normal();
  std::error_code error;
  if (fs::exists(path, error)) {
    return path;
  }
  std::string slashed = from.file;
  std::ranges::replace(slashed, '\\', '/');
  const fs::path other = (from.folder / slashed).lexically_normal();
  return fs::exists(other, error) ? other : path;
}

} // namespace

TextureTable::Entry* TextureTable::open(const MtlTexture& from) {
  const fs::path path = pathOf(from);
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  const auto [slot, isNew] = m_entries.try_emplace((error ? path : real).string());
  std::optional<Entry>& entry = slot->second;
  if (isNew) {
    entry = read(from, path);
  }
  return entry ? &*entry : nullptr;
}

std::optional<TextureTable::Entry> TextureTable::read(const MtlTexture& from, const fs::path& path) {
  try {
    ImageFile image = readImageFile(path);
    Entry entry;
    entry.least = entry.most = image.texels.at(0);
    for (const Vec3f& texel : image.texels) {
      entry.least = glm::min(entry.least, texel);
      entry.most = glm::max(entry.most, texel);
    }
    entry.texture = {path.string(), from.where, image.width, image.height, std::move(image.texels)};
    return entry;
  } catch (const SceneError& error) {
    m_report.warnings.push_back(
        fmt::format("{}: map_Kd: {}; Kd holds everywhere", from.where.text(), error.what()));
    return std::nullopt;
  }
}

std::uint32_t TextureTable::use(Entry& entry) {
  if (!entry.index) {
    entry.index = static_cast<std::uint32_t>(m_textures.size());
    m_textures.push_back(std::exchange(entry.texture, {}));
  }
  return *entry.index;
}

} // namespace vkpt
