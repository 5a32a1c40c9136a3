#include "app/environment_file.h"

#include "film/image.h"

#include <fmt/format.h>

#include <cmath>

namespace vkpt {

void readEnvironment(Scene& scene) {
  EnvironmentMap& map = scene.environment;
  if (map.file.empty())
    return;
  const Image image = readImage(map.file);
  map.width = image.width;
  map.height = image.height;
  map.radiance.resize(image.pixelCount());
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = image.channels[c].values[i];
      if (!(std::isfinite(value) && value >= 0.0F)) {
        const auto width = static_cast<std::size_t>(image.width);
        throw SceneError(
            {map.file.string()},
            fmt::format("pixel ({}, {}) holds {}; an environment's radiance is finite and not negative",
                        i % width, i / width, value));
      }
      map.radiance[i][static_cast<int>(c)] = value;
    }
  }
}

} // namespace vkpt
