#include "app/view/view_settings.h"

#include <algorithm>
#include <array>

namespace vkpt {

std::string_view shaderName(Shader shader) {
  constexpr std::array<std::string_view, kShaderCount> kNames{"base colour", "direct light", "normals",
                                                              "path tracing"};
  return kNames.at(static_cast<std::size_t>(shader));
}

EstimatorSettings ViewSettings::rendered() const {
  EstimatorSettings e = estimator;
  if (shader == Shader::DirectLight)
    e.maxBounces = std::min(e.maxBounces, 1U);
  if (e.lightTracing == LightTracing::On)
    e.lightTracing = LightTracing::Auto; // what the panel sets must not become an error
  return e;
}

bool differInFilm(const ViewSettings& a, const ViewSettings& b) {
  return a.shader != b.shader || (b.estimates() && a.rendered() != b.rendered());
}

} // namespace vkpt
