#pragma once
// The hard cases: what breaks path tracers in float, each with figures that a program can judge.

#include "selftest/trial.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt::selftest {

/// `run` leaves its figures in the trial; what it throws is a failure.
struct Case {
  const char* name; ///< its group and number, then its property: "d1-critical-angle"
  const char* what; ///< a sentence: what holds
  void (*run)(Trial&);
};

// A list a file. w: geometry; o: where rays start and end, normals; d: dielectrics, conductors, glossy
// surfaces; m: sums, roulette, random numbers; i: images and cameras; t: the driver.
std::span<const Case> driverCases();
std::span<const Case> watertightCases(); ///< rays between triangles
std::span<const Case> shapeCases();      ///< boxes, trees, sizes
std::span<const Case> rayCases();
std::span<const Case> oracleCases(); ///< device in float against host in double
std::span<const Case> formulaCases();
std::span<const Case> smoothCases(); ///< mirror, metal and glass
std::span<const Case> phongCases();
std::span<const Case> pathCases(); ///< furnaces, roulette, lights, colours
std::span<const Case> sumCases();
std::span<const Case> randomCases();
std::span<const Case> imageCases();

/// All of them, in the order of the groups.
std::vector<Case> allCases();
/// The case of this name; null if there is none.
const Case* findCase(std::string_view name);

struct CaseResult {
  Case which{};
  double seconds = 0.0;
  std::vector<Figure> figures;
  std::vector<std::string> failures;
  std::size_t conditions = 0; ///< looked at beside the figures
  std::vector<Film> pictures;
  [[nodiscard]] bool passed() const { return failures.empty(); }
};

/// Runs one case. A message of the validation layer is a failure.
CaseResult runCase(const Case& which, const gpu::Context& context, const Kernel& kernel = {},
                   std::uint32_t seed = 0);

/// Writes the result's pictures as FOLDER/NAME-0.exr and .png, ...
void keepPictures(const CaseResult& result, const fs::path& folder);

} // namespace vkpt::selftest
