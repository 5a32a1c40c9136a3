#pragma once
// What stands behind a map_* key: options, then the name of a file.

#include <string>
#include <string_view>
#include <vector>

namespace vkpt {

struct TextureArguments {
  std::string file;                            ///< may hold blanks; empty: none is named
  std::vector<std::string_view> unusedOptions; ///< "-s"; without those whose values change nothing
};

/// A word that is no option of the MTL format begins the name.
TextureArguments parseTextureArguments(std::string_view arguments);

} // namespace vkpt
