#pragma once
// One MTL text as materials in its own terms; materials.h makes Materials of them.

#include "core/error.h"
#include "core/math.h"
#include "scene/mtl_table.h"
#include "scene/sources.h"

#include <optional>
#include <string>
#include <vector>

namespace vkpt {

/// A key that a material gives and vkpt does not read; `key` is null where the table does not have it.
struct UnreadKey {
  const MtlKey* key = nullptr;
  std::string name;
  std::size_t line = 0;
};

/// What stands between one `newmtl` and the next; nothing where a key is absent.
struct MtlMaterial {
  std::string name;
  SourceLocation where;
  std::optional<Vec3d> kd, ks, ka, ke; ///< finite, not negative
  std::optional<double> ni;            ///< finite
  std::optional<int> illum;
  std::size_t kaLine = 0;
  std::size_t illumLine = 0;
  std::size_t niLine = 0;
  std::vector<UnreadKey> unread;
};

/// Throws SceneError at malformed or non-finite values of keys that are read, and at negative colours.
std::vector<MtlMaterial> readMtl(const SceneText& source, std::vector<std::string>& warnings);

} // namespace vkpt
