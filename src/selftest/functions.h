#pragma once
// Functions of the shader library, and of the driver, on the device: a row of arguments each.

#include "selftest/trial.h"

#include <array>
#include <span>
#include <vector>

namespace vkpt::selftest {

/// In the order of shaders/probe/functions.comp, which says what the arguments and results are.
enum class Function : std::uint32_t {
  Dielectric,
  Conductor,
  PhongValue,
  PhongSample,
  RoughSample,
  MisWeight,
  ToUnit,
  RandomBlock,
  Arithmetic,
  Powers,
  Extremes,
  Denormals,
  Contraction,
};

struct Row {
  std::array<float, 4> a{};
  std::array<float, 4> b{};
};

/// The function's result for each row, by the trial's kernels.
std::vector<Row> evaluate(const Trial& t, Function function, std::span<const Row> arguments);

/// Distance of a float from the exact value, in units of the float's last place there (of normal numbers).
double ulpsOff(float value, double exact);

} // namespace vkpt::selftest
