#include "app/assets_folder.h"

#include <fmt/format.h>

namespace vkpt {

fs::path assetsFolder(const fs::path& file) {
  const fs::path program = fs::canonical("/proc/self/exe").parent_path();
  const fs::path beside = program.parent_path() / "assets";
  const fs::path installed = program.parent_path() / "share" / "vkpt" / "assets";
  for (const fs::path& folder : {beside, installed}) {
    if (fs::exists(folder / file))
      return folder;
  }
  throw SceneError({file.string()}, fmt::format("is neither in {} nor in {}; both come with vkpt",
                                                beside.string(), installed.string()));
}

} // namespace vkpt
