#pragma once
// Nori files of tests: statistical tests of scenes whose radiance is known, and of BSDFs' sampling.

#include "core/error.h"
#include "scene/scene.h"

#include <vector>

namespace vkpt {

/// <test type="ttest">: Student's t-test of means against references. Either `bsdfs` or `scenes` are there.
struct NoriTTest {
  SourceLocation where;
  double significanceLevel = 0.01; ///< of the file; 0 to 1, both excluded
  int sampleCount = 100000;
  std::vector<double>
      references;             ///< one a scene; or one an angle, for one BSDF after the other. Luminances: of
                              ///< a scene's mean over its image, of the mean of a BSDF's sample weights
  std::vector<double> angles; ///< of incidence, degrees; only for BSDFs
  std::vector<Material> bsdfs;
  std::vector<Scene> scenes;
};

/// <test type="chi2test">: does sampling follow the density that pdf() claims?
struct NoriChi2Test {
  SourceLocation where;
  double significanceLevel = 0.01;
  int resolution = 10;       ///< of cos(theta); twice as many cells in phi
  int minExpFrequency = 5;   ///< cells in which fewer samples are expected are pooled
  int sampleCount = 1000000; ///< of the file; without: 5000 for a cell
  int testCount = 5;         ///< directions of incidence for each BSDF
  std::vector<Material> bsdfs;
};

struct NoriTests {
  std::vector<NoriTTest> tTests;
  std::vector<NoriChi2Test> chi2Tests;
};

/// Reads a file whose root is a <test>, or a <scene> that holds tests. Throws SceneError, also where there
/// are none.
NoriTests loadNoriTests(const fs::path& file, SceneReport& report);

} // namespace vkpt
