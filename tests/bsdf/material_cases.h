#pragma once
// The materials and the views that every check of the BSDFs goes through.

#include "bsdf/charts.h"
#include "bsdf/probe.h"
#include "scenes/scene_builder.h"

#include <ostream>
#include <string>
#include <vector>

namespace vkpt::test {

struct MaterialCase {
  std::string name;
  Material material;
  friend void PrintTo(const MaterialCase& c, std::ostream* out) { *out << c.name; }
};
/// Every BSDF that is no delta distribution.
std::span<const MaterialCase> materialCases();

struct BsdfCase {
  std::string name; ///< e.g. "ggxGlass05 at 45 degrees, from behind"
  View view;
  std::vector<Chart> charts; ///< that hold every direction the material scatters to
};
/// Every material at 0, 45 and 89 degrees; glass from both sides.
std::span<const BsdfCase> bsdfCases();

/// A triangle of each.
Scene sceneOf(std::span<const MaterialCase> materials);
/// Those that the materials call for, and no others.
EffectSet effectsOf(const Scene& scene);

} // namespace vkpt::test
