#include "unit/scene/nori_check.h"

#include <fmt/format.h>

namespace vkpt::test {

NoriFolder::NoriFolder() {
  write("square.obj", kSquare);
  write("plane.obj", "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nvn 0 1 0\nf 1//1 2//1 3//1 4//1\n");
}

Loaded NoriFolder::load(std::string_view xml) const { return test::load({write("scene.xml", xml)}); }

std::string NoriFolder::error(std::string_view xml) const {
  std::string what = errorOf({write("scene.xml", xml)});
  const std::string folder = path().string() + "/";
  for (auto at = what.find(folder); at != std::string::npos; at = what.find(folder)) {
    what.erase(at, folder.size());
  }
  return what;
}

std::string noriScene(std::string_view body, bool withCamera, bool withMesh) {
  return fmt::format("<scene>\n{}\n{}\n{}\n</scene>\n", body, withCamera ? kNoriCamera : "",
                     withMesh ? kNoriSquare : "");
}

std::string noriMesh(std::string_view file, std::string_view more) {
  return fmt::format(R"(<mesh type="obj"><string name="filename" value="{}"/>{}</mesh>)", file, more);
}

Loaded loadNoriBsdf(std::string_view bsdf) {
  return NoriFolder().load(noriScene(noriMesh("square.obj", bsdf), true, false));
}

} // namespace vkpt::test
