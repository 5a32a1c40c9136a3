// What is not called for is not there: the specialised kernel is smaller without it, whatever else the
// library knows.
#include "device/effects.h"
#include "effects/reduced.h"
#include "scene/load.h"
#include "spirv.h"

#include <gtest/gtest.h>

#include <iostream>
#include <map>

namespace vkpt::spirv {
extern const std::span<const std::uint32_t> kPlainPath;    ///< path.comp, not optimised
extern const std::span<const std::uint32_t> kExtendedPath; ///< the same with the BSDF of bsdf_velvet.glsl
} // namespace vkpt::spirv

namespace vkpt::test {
namespace {

constexpr std::uint32_t kVelvet = 63; ///< its effect: add_velvet.sh

EffectIds diffuseBox() {
  const fs::path name("cornell");
  SceneReport report;
  return idsOf(detectEffects(loadScene({&name, 1}, report), {}));
}

EffectIds with(EffectIds ids, std::uint32_t id) {
  ids.push_back(id);
  return ids;
}

/// How often each instruction occurs.
std::map<std::uint32_t, std::size_t> instructions(const Spirv& module) {
  constexpr std::size_t kHeader = 5;
  std::map<std::uint32_t, std::size_t> counts;
  for (std::size_t i = kHeader; i < module.size(); i += module[i] >> 16U)
    ++counts[module[i] & 0xFFFFU];
  return counts;
}

/// Out of everything, where what depends on it is still there.
TEST(KernelSize, IsSmallerWithoutAnyOneEffect) {
  const std::size_t all = reduced(spirv::kPath, idsOf(EffectSet::all())).size();
  for (const EffectInfo& e : allEffects()) {
    EffectSet rest = EffectSet::all();
    rest.set(e.effect, false);
    const std::size_t size = reduced(spirv::kPath, idsOf(rest)).size();
    std::cout << e.name << ": " << all - size << " of " << all << " words\n";
    EXPECT_LT(size, all) << e.name;
  }
}

TEST(KernelSize, DoesNotGrowWithTheLibrary) {
  const Spirv before = reduced(spirv::kPlainPath, diffuseBox());
  const Spirv after = reduced(spirv::kExtendedPath, diffuseBox());
  EXPECT_EQ(after.size(), before.size());
  EXPECT_EQ(instructions(after), instructions(before)) << "not the same instructions: not the same time";
  EXPECT_GT(reduced(spirv::kExtendedPath, with(diffuseBox(), kVelvet)).size(), before.size())
      << "the BSDF that was added is nowhere";
}

} // namespace
} // namespace vkpt::test
