// Nori's bsdf objects: their parameters, and the defaults of both editions.

#include "unit/scene/nori_check.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

Material only(std::string_view bsdf) {
  const auto [scene, report] = loadNoriBsdf(bsdf);
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_EQ(scene.materials.size(), 1U);
  return scene.materials.at(0);
}

TEST(NoriBsdf, AMeshWithoutOneIsDiffuse) {
  const Material m = only("");
  EXPECT_EQ(m.bsdf, BsdfType::Diffuse);
  EXPECT_EQ(m.reflectance, Vec3f(0.5F));
  EXPECT_FALSE(m.twoSided);
  EXPECT_EQ(m.name, "square");
}

TEST(NoriBsdf, Diffuse) {
  EXPECT_EQ(only(R"(<bsdf type="diffuse"/>)").reflectance, Vec3f(0.5F));
  const Material m = only(R"(<bsdf type="diffuse"><color name="albedo" value="0.1, .2 ,3e-1"/></bsdf>)");
  EXPECT_EQ(m.reflectance, Vec3f(0.1F, 0.2F, 0.3F));
  EXPECT_FALSE(m.twoSided);
  EXPECT_EQ(m.where.line, 2U);
  EXPECT_EQ(m.where.column, 62U);
}

TEST(NoriBsdf, Phong) {
  const Material defaults = only(R"(<bsdf type="phong"/>)");
  EXPECT_EQ(defaults.bsdf, BsdfType::Phong);
  EXPECT_EQ(defaults.reflectance, Vec3f(0.5F));
  EXPECT_EQ(defaults.specular, Vec3f(0.5F));
  EXPECT_EQ(defaults.exponent, 20.0F);
  EXPECT_FALSE(defaults.twoSided);
  const Material m = only(R"(<bsdf type="phong"><color name="kd" value="0 .1 .2"/>
      <color name="ks" value=".3 .4 .5"/><integer name="n" value="500"/></bsdf>)");
  EXPECT_EQ(m.reflectance, Vec3f(0.0F, 0.1F, 0.2F));
  EXPECT_EQ(m.specular, Vec3f(0.3F, 0.4F, 0.5F));
  EXPECT_EQ(m.exponent, 500.0F);
}

TEST(NoriBsdf, Mirror) {
  const Material m = only(R"(<bsdf type="mirror"/>)");
  EXPECT_EQ(m.bsdf, BsdfType::Mirror);
  EXPECT_EQ(m.reflectance, Vec3f(1.0F));
  EXPECT_FALSE(m.twoSided);
  EXPECT_EQ(only(R"(<bsdf type="mirror"><color name="reflectance" value="1 .5 0"/></bsdf>)").reflectance,
            Vec3f(1.0F, 0.5F, 0.0F));
}

TEST(NoriBsdf, Dielectric) {
  const Material defaults = only(R"(<bsdf type="dielectric"/>)");
  EXPECT_EQ(defaults.bsdf, BsdfType::Dielectric);
  EXPECT_EQ(defaults.intIor, 1.5046F);
  EXPECT_EQ(defaults.extIor, 1.000277F);
  EXPECT_EQ(defaults.absorption, Vec3f(0.0F));
  EXPECT_TRUE(defaults.twoSided) << "both sides refract";
  const Material m = only(R"(<bsdf type="dielectric"><float name="intIOR" value="1.33"/>
      <float name="extIOR" value="1"/><color name="absorption" value="1,2,3"/></bsdf>)");
  EXPECT_EQ(m.intIor, 1.33F);
  EXPECT_EQ(m.extIor, 1.0F);
  EXPECT_EQ(m.absorption, Vec3f(1, 2, 3));
}

TEST(NoriBsdf, Microfacet) {
  const Material defaults = only(R"(<bsdf type="microfacet"/>)");
  EXPECT_EQ(defaults.bsdf, BsdfType::Microfacet);
  EXPECT_EQ(defaults.roughness, 0.1F);
  EXPECT_EQ(defaults.intIor, 1.5046F);
  EXPECT_EQ(defaults.extIor, 1.000277F);
  EXPECT_EQ(defaults.reflectance, Vec3f(0.5F));
  EXPECT_EQ(defaults.specular, Vec3f(0.5F));
  EXPECT_EQ(defaults.distribution, MicrofacetDistribution::Beckmann);
  EXPECT_FALSE(defaults.twoSided);
  const Material m = only(R"(<bsdf type="microfacet"><color name="kd" value=".1 .25 0"/>
      <float name="alpha" value=".3"/></bsdf>)");
  EXPECT_EQ(m.specular, Vec3f(0.75F)) << "1 - max(kd)";
  EXPECT_EQ(m.roughness, 0.3F);
}

TEST(NoriBsdf, ConductorByNameOrByItsIndex) {
  const Material gold = only(R"(<bsdf type="conductor"><string name="material" value="Gold"/></bsdf>)");
  EXPECT_EQ(gold.bsdf, BsdfType::Conductor);
  EXPECT_EQ(gold.eta, Vec3f(0.284611F, 0.488326F, 1.017676F));
  EXPECT_EQ(gold.k, Vec3f(3.983F, 2.386F, 1.603F));
  EXPECT_EQ(gold.reflectance, Vec3f(1.0F));
  EXPECT_FALSE(gold.twoSided);
  const Material m = only(R"(<bsdf type="conductor"><color name="eta" value="1 2 3"/>
      <color name="k" value="4 5 6"/></bsdf>)");
  EXPECT_EQ(m.eta, Vec3f(1, 2, 3));
  EXPECT_EQ(m.k, Vec3f(4, 5, 6));
}

TEST(NoriBsdf, RoughConductor) {
  const Material m = only(R"(<bsdf type="roughconductor"><string name="material" value="silver"/></bsdf>)");
  EXPECT_EQ(m.bsdf, BsdfType::RoughConductor);
  EXPECT_EQ(m.roughness, 0.1F);
  EXPECT_EQ(m.distribution, MicrofacetDistribution::Ggx);
  EXPECT_EQ(m.eta.x, 0.126136F);
  const Material other = only(R"(<bsdf type="roughconductor"><string name="material" value="silver"/>
      <string name="distribution" value="beckmann"/><float name="alpha" value=".4"/></bsdf>)");
  EXPECT_EQ(other.roughness, 0.4F);
  EXPECT_EQ(other.distribution, MicrofacetDistribution::Beckmann);
}

TEST(NoriBsdf, RoughDielectric) {
  const Material m = only(R"(<bsdf type="roughdielectric"><float name="alpha" value=".2"/>
      <float name="intIOR" value="1.7"/></bsdf>)");
  EXPECT_EQ(m.bsdf, BsdfType::RoughDielectric);
  EXPECT_EQ(m.roughness, 0.2F);
  EXPECT_EQ(m.intIor, 1.7F);
  EXPECT_EQ(m.extIor, 1.000277F);
  EXPECT_EQ(m.distribution, MicrofacetDistribution::Ggx);
}

TEST(NoriBsdf, WithoutRoughnessIsSmooth) {
  EXPECT_EQ(only(R"(<bsdf type="roughdielectric"><float name="alpha" value="0"/></bsdf>)").bsdf,
            BsdfType::Dielectric);
  EXPECT_EQ(only(R"(<bsdf type="roughconductor"><string name="material" value="gold"/>
      <float name="alpha" value="1e-9"/></bsdf>)")
                .bsdf,
            BsdfType::Conductor);
}

TEST(NoriBsdf, AlbedosAboveOneAreKeptWithOneWarningAMesh) {
  const NoriFolder folder;
  const std::string mesh =
      noriMesh("square.obj", R"(<bsdf type="diffuse"><color name="albedo" value="1.3 .4 1.5"/></bsdf>)");
  const auto [scene, report] = folder.load(noriScene(mesh + "\n" + mesh, true, false));
  EXPECT_EQ(scene.materials.at(0).reflectance, Vec3f(1.3F, 0.4F, 1.5F));
  EXPECT_EQ(countContaining(report.warnings, "is above 1"), 2U);
  EXPECT_TRUE(anyContains(report.warnings, "scene.xml:3:83: albedo 1.3 0.4 1.5 is above 1"));
}

TEST(NoriBsdf, SumsAboveOneWarnAndSumsOfOneDoNot) {
  EXPECT_TRUE(anyContains(
      loadNoriBsdf(R"(<bsdf type="phong"><color name="ks" value="1 1 1"/></bsdf>)").report.warnings,
      "scene.xml:2:62: kd + ks 1.5 1.5 1.5 is above 1"));
  EXPECT_TRUE(loadNoriBsdf(R"(<bsdf type="phong"><color name="kd" value=".7 .9 .6"/>
      <color name="ks" value=".3 .1 .4"/></bsdf>)")
                  .report.warnings.empty());
  EXPECT_TRUE(anyContains(
      loadNoriBsdf(R"(<bsdf type="mirror"><color name="reflectance" value="2 1 1"/></bsdf>)").report.warnings,
      "reflectance 2 1 1 is above 1"));
}

TEST(NoriBsdf, PropertiesOfAnotherBsdfAreWarnedAboutWithThoseItHas) {
  const auto [scene, report] =
      loadNoriBsdf("\n"
                   R"(<bsdf type="diffuse"> <color name="kd" value=".5 .4 .3"/></bsdf>)");
  EXPECT_EQ(scene.materials.at(0).reflectance, Vec3f(0.5F)) << "Nori's diffuse reads albedo alone";
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_TRUE(report.warnings[0].ends_with(
      "scene.xml:3:23: bsdf 'diffuse' has no property 'kd', so it is ignored; it has albedo"))
      << report.warnings[0];
  EXPECT_TRUE(anyContains(
      loadNoriBsdf(R"(<bsdf type="dielectric"><float name="intIor" value="2"/></bsdf>)").report.warnings,
      "no property 'intIor', so it is ignored; it has intIOR, extIOR, absorption, did you mean 'intIOR'?"));
}

TEST(NoriBsdf, APropertyGivenTwiceWarnsAndTheLastHolds) {
  const auto [scene, report] = loadNoriBsdf("<bsdf type='diffuse'>\n<color name='albedo' value='.1 .1 "
                                            ".1'/>\n<color name='albedo' value='.2 .2 .2'/></bsdf>");
  EXPECT_EQ(scene.materials.at(0).reflectance, Vec3f(0.2F));
  EXPECT_TRUE(anyContains(report.warnings, "scene.xml:4:1: 'albedo' again, first at line 3"));
}

} // namespace
} // namespace vkpt::test
