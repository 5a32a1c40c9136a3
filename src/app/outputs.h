#pragma once
// The files that a run writes: looked at before it, written after it.

#include "app/run_report.h"

namespace vkpt {

/// Mean radiance of each kind of light path, by pixel; empty unless they are wanted.
using KindImages = std::vector<std::vector<Vec3d>>;

/// To be called before anything is loaded. Throws UsageError where an image or the stats could not be
/// written: unknown extension, no such folder, a folder in its place, not writable, or two outputs of one
/// name.
void checkOutputs(const RenderOptions& options);
/// To be called before rendering. Throws UsageError where an image format cannot hold that many pixels.
void checkOutputSizes(const RenderOptions& options, int width, int height);

/// Each is there as a whole or not at all.
void writeImages(const RenderOptions& options, const RunReport& report, const Film& film,
                 const KindImages& kinds);
void writeStats(const RenderOptions& options, const RunReport& report);

} // namespace vkpt
