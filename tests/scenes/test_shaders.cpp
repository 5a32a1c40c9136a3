#include "scenes/test_shaders.h"

#include "selftest/shaders.h"
#include "spirv.h"

#include <stdexcept>
#include <utility>

namespace vkpt::test {
namespace {

selftest::Spirv mutableBuild(selftest::Spirv shipped) {
  const std::pair<selftest::Spirv, selftest::Spirv> builds[] = {
      {spirv::kPath, spirv::kMutablePath},
      {spirv::kFirstVertices, spirv::kMutableFirstVertices},
      {spirv::kSharePaths, spirv::kMutableSharePaths},
      {spirv::kFunctions, spirv::kMutableFunctions},
      {spirv::kPathRecords, spirv::kMutablePathRecords},
      {spirv::kSums, spirv::kMutableSums},
  };
  for (const auto& [original, build] : builds) {
    if (shipped.data() == original.data())
      return build;
  }
  throw std::invalid_argument("a shader without a test build");
}

} // namespace

selftest::Kernel mutatedKernel(std::uint32_t mutation) { return {mutation, mutableBuild}; }

} // namespace vkpt::test
