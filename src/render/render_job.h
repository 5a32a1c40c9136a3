#pragma once
// What to render and when to stop.

#include "render/dispatch_sizer.h"
#include "render/integrator.h"

#include <optional>

namespace vkpt {

enum class StopReason { Frames, Time, Error, User, Fault };
/// The promised names: "frames", "time", "error", "user", "fault".
const char* stopReasonName(StopReason reason);

inline constexpr std::uint32_t kMostTileBlocks =
    16384; ///< in a unit of work: 2^20 slots, 96 MB of path states

struct RenderJob {
  std::optional<std::uint64_t> frames; ///< samples for every pixel
  std::optional<double> seconds;       ///< of rendering
  std::optional<double> targetError;   ///< relative error of the image, 95 % confident
  std::uint32_t batch =
      shared::kSamplesPerGroup;      ///< frames per unit of work, 1..kSamplesPerGroup; no image depends on it
  std::uint32_t tileBlocks = 0;      ///< blocks per unit of work; 0: by measured time. No image depends on it
  double unitSeconds = kUnitSeconds; ///< that a unit of work is to take where it is sized by measured time
  /// Begin with batches of one frame, and let them grow with the frames that are there: every pixel soon has
  /// a sample, and late ones cost as little as without. No image depends on it.
  bool growingBatch = false;
  /// Looks at the film while it is rendered on: what they find, a target error met too, is known a little
  /// later.
  bool looksAside = false;
};

} // namespace vkpt
