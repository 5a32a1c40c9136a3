#pragma once
// What the options and the scene's file together come to.

#include "app/options.h"

namespace vkpt {

/// In the order of PathKind: "emission", "direct", ...
std::string_view pathKindName(PathKind kind);

/// The filter that an option names, with the frameworks' defaults for its parameters.
PixelFilter namedFilter(PixelFilter::Shape shape);

/// The horizontal field of view for an image of this aspect, width over height; degrees.
double horizontalFov(const Camera& camera, double aspect);

/// What is rendered: an option comes before what the scene's file says, that before the default. Termination
/// with probability 1 becomes a limit on bounces.
EstimatorSettings estimatorFor(const RenderOptions& options, const Scene& scene);

/// The options and file settings that bias the image, as text; empty by default.
std::vector<std::string> biasOf(const RenderOptions& options, const EstimatorSettings& estimator);

/// Every option as it was expanded, in lines, for --verbose: `job` and `scene` hold what the defaults came
/// to.
std::vector<std::string> describeOptions(const RenderOptions& options, const RenderJob& job,
                                         const Scene& scene, const EstimatorSettings& estimator);

} // namespace vkpt
