#include "scene/mtl_table.h"

#include "scene/names.h"

#include <algorithm>

namespace vkpt {

const MtlKey* findMtlKey(std::string_view key) {
  const auto found = std::ranges::find(kMtlKeys, key, &MtlKey::key);
  return found == kMtlKeys.end() ? nullptr : &*found;
}

const IllumModel* findIllumModel(int illum) {
  const auto found = std::ranges::find(kIllumModels, illum, &IllumModel::illum);
  return found == kIllumModels.end() ? nullptr : &*found;
}

const Metal* findMetal(std::string_view materialName) {
  const auto dot = materialName.rfind('.');
  if (dot != std::string_view::npos &&
      materialName.find_first_not_of("0123456789", dot + 1) == std::string_view::npos) {
    materialName = materialName.substr(0, dot);
  }
  const auto found = std::ranges::find(kMetals, lowerCase(materialName), &Metal::name);
  return found == kMetals.end() ? nullptr : &*found;
}

} // namespace vkpt
