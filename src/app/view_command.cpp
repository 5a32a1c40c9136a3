// `vkpt view`: the preview is another program, so that this one never loads a window library.

#include "app/commands.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace vkpt {

ExitCode runView(const std::vector<std::string>& arguments) {
  std::error_code failed;
  const fs::path self = fs::read_symlink("/proc/self/exe", failed);
  const fs::path program = self.parent_path() / "vkpt-view";
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  throw DeviceError(fmt::format("{}: {}; the preview is built where libglfw3-dev and libimgui-dev are "
                                "installed; vkpt, without view, renders into files",
                                program.string(), std::strerror(errno)));
}

} // namespace vkpt
