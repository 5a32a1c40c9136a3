#include "selftest/functions.h"

#include "selftest/shaders.h"
#include "selftest/small_program.h"

#include <algorithm>
#include <cmath>

namespace vkpt::selftest {
namespace {

constexpr std::uint32_t kFunctionConstant = 100; // constant_id of kFunction
constexpr std::size_t kGroupSize = 64;           // local_size_x

} // namespace

std::vector<Row> evaluate(const Trial& t, Function function, std::span<const Row> arguments) {
  std::vector<Row> results(arguments.size());
  gpu::SpecialisationMap constants = t.kernel().constants();
  constants[kFunctionConstant] = static_cast<std::uint32_t>(function);
  const auto groups = static_cast<std::uint32_t>((arguments.size() + kGroupSize - 1) / kGroupSize);
  runSmallProgram(t.context(), {t.kernel().of(spirv::kFunctions), constants, shared::kBindingCount, groups},
                  std::as_bytes(arguments), std::as_writable_bytes(std::span{results}));
  return results;
}

double ulpsOff(float value, double exact) {
  if (!std::isfinite(value) || !std::isfinite(exact))
    return static_cast<double>(value) == exact ? 0.0 : HUGE_VAL;
  const int exponent = std::max(std::ilogb(exact == 0.0 ? 0x1p-126 : exact), -126);
  return std::abs(static_cast<double>(value) - exact) / std::ldexp(1.0, exponent - 23);
}

} // namespace vkpt::selftest
