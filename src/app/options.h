#pragma once
// The command line.

#include "app/effects_option.h"
#include "core/log.h"
#include "film/image.h"
#include "render/render_job.h"

#include <optional>
#include <string>
#include <vector>

namespace vkpt {

/// Of the samples that begin at specular surfaces, which are as a rule few and noisy.
inline constexpr std::uint32_t kSpecularSamples = 4;

struct RenderOptions {
  std::vector<fs::path> scenes;
  RenderJob job;
  std::optional<double> pilotSeconds; ///< for each setting that is tried before the render; empty: none is
  bool endless = false; ///< where no rule stops the run it goes on, in place of the scene's own count
  /// Where a scene may say otherwise, by estimatorFor().
  EstimatorSettings estimator{.sampler = Sampler::Sobol,
                              .lightSelection = LightSelection::Auto,
                              .lightTracing = LightTracing::Auto,
                              .guiding = Guiding::Auto,
                              .specularSamples = kSpecularSamples};
  std::optional<LightStrategy> light;
  std::optional<std::uint32_t> maxBounces;
  std::optional<std::uint32_t> pathKinds; ///< bit i: PathKind i
  std::optional<PixelFilter::Shape> filter;
  EffectsOption effects;
  bool measure = false; ///< explain: what the effects cost
  bool json = false;    ///< explain: JSON in place of a table
  fs::path kindPrefix;  ///< of the images of the kinds of light path; empty: none
  std::optional<std::pair<int, int>> size;
  std::vector<fs::path> outputs;
  DisplaySettings display;
  std::uint32_t seed = 0;
  std::optional<Vec3f> background;
  fs::path environment;                          ///< an image; empty: the scene's
  std::optional<std::pair<Vec3d, Vec3d>> lookAt; ///< eye, target
  std::optional<Vec3d> up;
  std::optional<double> fovDegrees;         ///< horizontal
  std::optional<std::pair<int, int>> pixel; ///< of the path that is replayed
  std::uint64_t sample = 0;                 ///< its index
  std::vector<std::string> arguments;       ///< as they were typed
  std::string device;
  fs::path stats;
  bool strict = false;
  bool progress = true;
  bool validation = false;
  LogLevel log = LogLevel::Normal; ///< Quiet: no summary either
};

enum class Command { Render, Devices, Replay, Explain, ListScenes, Exit };

struct CommandLine {
  Command command = Command::Render;
  RenderOptions render;
};

/// Parses the arguments, without the program's name. Prints help or version itself (command Exit). Throws
/// UsageError: one line that names the option, what is wrong, and what would be right.
CommandLine parseCommandLine(const std::vector<std::string>& arguments);

} // namespace vkpt
