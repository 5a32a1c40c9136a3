#pragma once
// What the user can change while the preview runs.

#include "app/view/film_picture.h"
#include "render/render_job.h"

#include <string_view>

namespace vkpt {

/// By number key, as in the assignments' frameworks.
enum class Shader { BaseColour = 0, DirectLight = 1, Normals = 2, PathTracing = 3 };
inline constexpr int kShaderCount = 4;
std::string_view shaderName(Shader shader);

struct ViewSettings {
  Shader shader = Shader::PathTracing;
  EstimatorSettings estimator; ///< of path tracing
  RenderJob job;               ///< its rules to stop
  DisplaySettings display;
  Shows shows = Shows::Mean;
  bool paused = false;
  bool panel = true;

  /// Of what is rendered: direct light is path tracing of one bounce.
  [[nodiscard]] EstimatorSettings rendered() const;
  [[nodiscard]] bool estimates() const {
    return shader == Shader::PathTracing || shader == Shader::DirectLight;
  }
};

/// Whether the film of `a` is no film of `b`: it must be begun again.
bool differInFilm(const ViewSettings& a, const ViewSettings& b);

} // namespace vkpt
