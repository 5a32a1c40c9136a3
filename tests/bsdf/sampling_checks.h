#pragma once
// What is demanded of the samples of a BSDF. Each check returns what it found wrong, so that the tests of the
// mutations can count on it too.

#include "bsdf/material_cases.h"
#include "bsdf/oracle.h"

#include <string>
#include <vector>

namespace vkpt::test {

using Failures = std::vector<std::string>;

/// The BSDFs on the device beside the same in double.
struct BsdfBench {
  explicit BsdfBench(std::uint32_t mutation = 0);
  Scene scene;
  Probe probe;
  Oracle oracle;
};

/// Draws against the density integrated over the cells of the charts and over what is left, by chi-square;
/// and their mean weight against the integral of f cos. `tests`: of which none may fail by chance but with
/// probability kFamilyAlpha.
Failures checkDensity(BsdfBench& bench, const BsdfCase& c, std::size_t tests);

/// Weight and density of each draw against f cos / pdf and pdf in double, to what rounding the directions to
/// float makes of them; density above 0; neither NaN nor infinite.
Failures checkWeights(BsdfBench& bench, const BsdfCase& c);

/// f and pdf for any directions, device against double, as far as rounding goes.
Failures checkEvaluation(BsdfBench& bench, const BsdfCase& c);

/// How much a function of both directions changes where rounding to float may move them: the tolerance of a
/// comparison between float and double.
using OfDirections = std::function<double(const Vec3d& wo, const Vec3d& wi)>;
double roundingOf(const Vec3d& wo, const Vec3d& wi, const OfDirections& f);

} // namespace vkpt::test
