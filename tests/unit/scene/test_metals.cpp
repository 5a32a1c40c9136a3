#include "scene/mtl_table.h"

#include "unit/scene/scene_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

/// Of light that falls straight on a metal, in double.
Vec3d normalReflectance(const Metal& metal) {
  const Vec3d n(metal.eta);
  const Vec3d k(metal.k);
  return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

void expectReflectance(const char* name, const Vec3d& expected, double tolerance) {
  const Metal* metal = findMetal(name);
  ASSERT_NE(metal, nullptr) << name;
  EXPECT_LT(glm::length(normalReflectance(*metal) - expected), tolerance) << name;
}

TEST(Metals, ReflectWhatTheMeasurementsSay) {
  expectReflectance("silver", {0.9679, 0.9571, 0.9179}, 1e-4); // four digits, three channels
  expectReflectance("gold", {0.935, 0.753, 0.387}, 1e-5);
  expectReflectance("copper", {0.854, 0.646, 0.549}, 1e-5);
}

TEST(Metals, SilverHasTheFrameworksIndices) {
  const auto [scene, report] = loadText("mtllib scene.mtl\nusemtl silver\n" + std::string(kSquare),
                                        "newmtl silver\nKs .96 .98 .96\nNi .177\nNs 96\nillum 11\n");
  const Material& silver = scene.materials.at(0);
  EXPECT_EQ(silver.bsdf, BsdfType::Conductor);
  EXPECT_EQ(silver.eta, Vec3f(0.126136F, 0.126423F, 0.150656F));
  EXPECT_EQ(silver.k, Vec3f(3.803187F, 3.244109F, 2.453368F));
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Metals, AreFoundInAnyCaseAndWithAModellersNumber) {
  EXPECT_EQ(findMetal("SILVER.001"), findMetal("silver"));
  EXPECT_EQ(findMetal("Gold"), findMetal("gold"));
  for (const char* name : {"", "silverish", "silver.old", "aluminium", ".001"}) {
    EXPECT_EQ(findMetal(name), nullptr) << name;
  }
}

} // namespace
} // namespace vkpt::test
