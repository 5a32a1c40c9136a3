#pragma once
// The film into files, by the same way as the headless command's.

#include "app/render_run.h"
#include "app/view/stage.h"

namespace vkpt {

/// What the preview adds to a report: how the film came to be.
struct ViewRun {
  RenderResult result;
  ViewSettings settings;
  std::string device;
};

RunReport reportOf(const RenderOptions& options, const PreparedRun& prepared, const Stage& stage,
                   const ViewRun& run, const Film& film);

/// Writes the images with all metadata: to the names of --output, else to SCENE-1.png and SCENE-1.exr with
/// the first number that is free. Returns their names.
std::vector<fs::path> saveFilm(const RenderOptions& options, bool named, const PreparedRun& prepared,
                               const Stage& stage, const ViewRun& run, const Film& film);

/// "--look-at ... --up ... --fov ...": options that give this camera again for an image of this aspect.
std::string cameraOptions(const Camera& camera, double aspect);

} // namespace vkpt
