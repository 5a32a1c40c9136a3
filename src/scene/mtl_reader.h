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

/// A key, or an option of one, that a material gives and vkpt does not read.
struct UnreadKey {
  std::string name;
  std::string warning;
  std::size_t line = 0;
};

/// An image file that a material names.
struct MtlTexture {
  std::string file; ///< as it is written
  fs::path folder;  ///< what `file` is relative to
  SourceLocation where;
};

/// What stands between one `newmtl` and the next; nothing where a key is absent.
struct MtlMaterial {
  std::string name;
  SourceLocation where;
  std::optional<Vec3d> kd, ks, ka, ke; ///< finite, not negative
  std::optional<double> ni, ns;        ///< finite
  std::optional<MtlTexture> mapKd;
  std::optional<int> illum;
  std::size_t kaLine = 0;
  std::size_t illumLine = 0;
  std::size_t niLine = 0;
  std::size_t nsLine = 0;
  std::vector<UnreadKey> unread;
};

/// Throws SceneError at malformed or non-finite values of keys that are read, and at negative colours.
std::vector<MtlMaterial> readMtl(const SceneText& source, std::vector<std::string>& warnings);

} // namespace vkpt
