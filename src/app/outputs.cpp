#include "app/outputs.h"

#include "app/expanded_options.h"
#include "film/codecs.h"
#include "scene/names.h"

#include <fmt/format.h>

#include <set>

namespace vkpt {
namespace {

/// One name for each kind and each format that is written.
std::vector<fs::path> kindPaths(const RenderOptions& o, std::uint32_t kind) {
  std::vector<fs::path> paths;
  std::set<std::string> extensions;
  for (const auto& path : o.outputs) {
    if (!o.kindPrefix.empty() && extensions.insert(path.extension().string()).second)
      paths.emplace_back(fmt::format("{}-{}{}", o.kindPrefix.string(),
                                     pathKindName(static_cast<PathKind>(kind)), path.extension().string()));
  }
  return paths;
}

void fillChannels(Image& image, std::size_t first, const std::vector<Vec3d>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      image.channels[first + c].values[i] = static_cast<float>(values[i][static_cast<int>(c)]);
  }
}

/// The kinds as layers beside R, G and B.
void addLayers(Image& image, const KindImages& kinds) {
  for (std::uint32_t k = 0; k < kinds.size(); ++k) {
    const std::size_t first = image.channels.size();
    for (const char* channel : {"R", "G", "B"})
      image.addChannel(fmt::format("{}.{}", pathKindName(static_cast<PathKind>(k)), channel));
    fillChannels(image, first, kinds[k]);
  }
}

} // namespace

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
  for (std::uint32_t kind = 0; kind < kPathKindCount; ++kind) {
    for (const auto& path : kindPaths(o, kind)) {
      checkOutputPath(path);
      checkName(path);
    }
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

void writeImages(const RenderOptions& o, const RunReport& report, const Film& film, const KindImages& kinds) {
  Image image = develop(film);
  addLayers(image, kinds);
  const Metadata metadata = imageMetadata(report);
  for (const auto& path : o.outputs)
    writeImage(path, image, o.display, metadata);
  for (std::uint32_t k = 0; k < kinds.size(); ++k) {
    Image single(image.width, image.height, {"R", "G", "B"});
    fillChannels(single, 0, kinds[k]);
    for (const auto& path : kindPaths(o, k))
      writeImage(path, single, o.display, metadata);
  }
}

void writeStats(const RenderOptions& o, const RunReport& report) {
  if (o.stats.empty())
    return;
  film::writeTextFile(o.stats, statsJson(report));
}

} // namespace vkpt
