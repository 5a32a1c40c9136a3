#include "app/outputs.h"

#include "film/codecs.h"
#include "scene/names.h"

#include <fmt/format.h>

#include <set>

namespace vkpt {

void checkOutputs(const RenderOptions& o) {
  std::set<fs::path> names;
  const auto checkName = [&names](const fs::path& path) {
    if (!names.insert(fs::absolute(path).lexically_normal()).second)
      throw UsageError(fmt::format("{}: written twice; give each output a name of its own", path.string()));
  };
  for (const auto& path : o.outputs) {
    if (path.empty())
      throw UsageError("--output '': expected a file name in .png, .exr, .hdr or .pfm");
    checkOutputPath(path);
    checkName(path);
  }
  if (!o.stats.empty()) {
    const film::AtomicFile trial(o.stats); // not committed: removed again
    checkName(o.stats);
  }
}

void checkOutputSizes(const RenderOptions& o, int width, int height) {
  for (const auto& path : o.outputs) {
    const std::string extension = lowerCase(path.extension().string());
    try {
      if (extension == ".png")
        film::checkPngSize(width, height);
      if (extension == ".hdr")
        film::checkHdrSize(width, height);
    } catch (const UsageError& e) {
      throw UsageError(fmt::format("{}: {}", path.string(), e.what()));
    }
  }
}

void writeImages(const RenderOptions& o, const RunReport& report, const Film& film) {
  const Image image = develop(film);
  for (const auto& path : o.outputs)
    writeImage(path, image, o.display, imageMetadata(report));
}

void writeStats(const RenderOptions& o, const RunReport& report) {
  if (o.stats.empty())
    return;
  const std::string text = statsJson(report);
  film::AtomicFile file(o.stats);
  file.write({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
  file.commit();
}

} // namespace vkpt
