#include "unit/scene/scene_check.h"

#include "scene/mtl_table.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

const std::string kUseM = "mtllib scene.mtl\nusemtl m\n" + std::string(kSquare);

Loaded loadMaterial(const std::string& body) { return loadText(kUseM, "newmtl m\n" + body); }
Material materialOf(const std::string& body) { return loadMaterial(body).scene.materials.at(0); }
Vec3f emissionOf(const std::string& body) { return materialOf(body).emission; }

TEST(Emission, KeIsEmissionWhateverKd) {
  EXPECT_EQ(emissionOf("Kd .8 .8 .8\nKe 5 4 3\nillum 1\n"), Vec3f(5, 4, 3));
  EXPECT_EQ(emissionOf("Kd 0 0 0\nKa .5 .5 .5\nKe 5 4 3\nillum 1\n"), Vec3f(5, 4, 3)) << "Ke before Ka";
}

TEST(Emission, KaIsEmissionWhereKdIsZero) {
  EXPECT_EQ(emissionOf("Ka 36.8 31.2 16\nKd 0 0 0\nillum 1\n"), Vec3f(36.8F, 31.2F, 16.0F));
  EXPECT_EQ(emissionOf("Ka .5 .25 0\nKd 0 0 0\nillum 1\n"), Vec3f(0.5F, 0.25F, 0.0F));
  EXPECT_EQ(emissionOf("Kd 0 0 0\nKa 1 1 1\nillum 1\n"), Vec3f(1.0F)) << "in either order";
}

TEST(Emission, KaIsEmissionWhereAChannelIsAboveOne) {
  EXPECT_EQ(emissionOf("Ka .1 .1 1.5\nKd .8 .8 .8\nillum 1\n"), Vec3f(0.1F, 0.1F, 1.5F));
  EXPECT_EQ(emissionOf("Ka 10 10 10\nillum 1\n"), Vec3f(10.0F)) << "no Kd";
}

TEST(Emission, KaOfAModellerIsNone) {
  EXPECT_EQ(emissionOf("Ka 1 1 1\nKd .8 .8 .8\nKs .5 .5 .5\nKe 0 0 0\nillum 1\n"), Vec3f(0.0F))
      << "Blender's";
  EXPECT_EQ(emissionOf("Ka .2 .2 .2\nKd 0 0 .1\nillum 1\n"), Vec3f(0.0F)) << "Kd is not 0 in all channels";
  EXPECT_EQ(emissionOf("Ka 1 1 1\nillum 1\n"), Vec3f(0.0F)) << "Kd absent: 0.8";
  EXPECT_EQ(emissionOf("Ka 0 0 0\nKd 0 0 0\nillum 3\n"), Vec3f(0.0F));
}

TEST(Emission, KaThatEmitsIsNoted) {
  const auto [scene, report] = loadMaterial("Kd 0 0 0\nKa 2 3 4\n");
  EXPECT_TRUE(anyContains(report.notes, "scene.mtl:3: material 'm' emits its Ka, 2 3 4"));
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Illum, ChoosesTheShader) {
  for (const char* diffuse : {"illum 0\n", "illum 1\n", "illum 2\n", "illum 2\nKs 0 0 0\n", ""}) {
    const auto [scene, report] = loadMaterial(std::string("Kd .1 .2 .3\nNs 100\n") + diffuse);
    EXPECT_EQ(scene.materials[0].bsdf, BsdfType::Diffuse) << diffuse;
    EXPECT_EQ(scene.materials[0].reflectance, Vec3f(0.1F, 0.2F, 0.3F)) << diffuse;
    EXPECT_TRUE(report.warnings.empty()) << diffuse;
  }
  const Material mirror = materialOf("Kd .1 .1 .1\nKs .5 .5 .5\nillum 3\n");
  EXPECT_EQ(mirror.bsdf, BsdfType::Mirror);
  EXPECT_EQ(mirror.reflectance, Vec3f(1.0F)) << "Ks has no effect on a mirror";
  for (const char* glass : {"illum 4\n", "illum 6\n", "illum 7\n"}) {
    const auto [scene, report] = loadMaterial(std::string("Ni 1.33\n") + glass);
    EXPECT_EQ(scene.materials[0].bsdf, BsdfType::Dielectric);
    EXPECT_EQ(scene.materials[0].intIor, 1.33F);
    EXPECT_EQ(scene.materials[0].extIor, 1.0F);
    EXPECT_TRUE(report.warnings.empty());
  }
  EXPECT_EQ(materialOf("illum 4\n").intIor, 1.5F) << "Ni absent";
}

TEST(Illum, WithKsIsPhong) {
  const auto [scene, report] = loadMaterial("Kd .25 .5 .125\nKs .5 .25 0\nNs 100.5\nillum 2\n");
  const Material& phong = scene.materials[0];
  EXPECT_EQ(phong.bsdf, BsdfType::Phong);
  EXPECT_EQ(phong.reflectance, Vec3f(0.25F, 0.5F, 0.125F));
  EXPECT_EQ(phong.specular, Vec3f(0.5F, 0.25F, 0.0F));
  EXPECT_EQ(phong.exponent, 100.5F) << "as it is written";
  EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
  EXPECT_EQ(materialOf("Ks 0 0 .1\nNs 1\n").bsdf, BsdfType::Phong) << "illum absent: 2";
  EXPECT_EQ(materialOf("Ks 1 1 1\nNs 1\nillum 1\n").bsdf, BsdfType::Diffuse);
  const Material black = materialOf("Kd 0 0 0\nKs 0 0 0\nNs -1\nillum 2\n");
  EXPECT_EQ(black.bsdf, BsdfType::Diffuse) << "whose Ns nobody asks for";
  EXPECT_EQ(black.reflectance, Vec3f(0.0F));
  EXPECT_EQ(black.specular, Vec3f(0.0F));
}

TEST(Illum, OfPhongExponents) {
  EXPECT_EQ(materialOf("Ks 1 1 1\nNs 0\n").exponent, 0.0F);
  EXPECT_EQ(materialOf("Ks 1 1 1\nNs 1e6\n").exponent, 1e6F);
  const auto [scene, report] = loadMaterial("Kd 0 0 0\nKs 1 1 1\n");
  EXPECT_EQ(scene.materials[0].exponent, 0.0F);
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_TRUE(
      anyContains(report.warnings, "scene.mtl:1: material 'm': a Phong lobe (Ks above 0) without Ns"));
}

TEST(Illum, OfPhongThatGainsEnergyWarns) {
  const auto [scene, report] = loadMaterial("Kd .5 .2 1\nKs 1 .8 0\nNs 2\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3f(0.5F, 0.2F, 1.0F));
  EXPECT_EQ(scene.materials[0].specular, Vec3f(1.0F, 0.8F, 0.0F));
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_TRUE(anyContains(report.warnings, "Kd 0.5 0.2 1 and Ks 1 0.8 0 add up to more than 1"))
      << report.warnings[0];
  for (const char* sums : {"Kd .7 .6 .9\nKs .3 .4 .1\nNs 2\n", "Kd .1 .1 .1\nKs .9 .9 .9\nNs 2\n"}) {
    EXPECT_TRUE(loadMaterial(sums).report.warnings.empty()) << "1 in decimals";
  }
}

TEST(Illum, TwelveAbsorbs) {
  const auto [scene, report] = loadMaterial("Kd 1 .5 .1\nNi 1.335\nillum 12\n");
  const Material& wine = scene.materials[0];
  EXPECT_EQ(wine.bsdf, BsdfType::Dielectric);
  EXPECT_EQ(wine.intIor, 1.335F);
  EXPECT_EQ(wine.reflectance, Vec3f(1.0F));
  EXPECT_EQ(wine.absorption, Vec3f(0.0F, 1.0F, 9.0F)) << "1 / Kd - 1";
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_EQ(materialOf("illum 12\n").absorption, Vec3f(0.25F)) << "Kd absent: 0.8";
  EXPECT_EQ(materialOf("Kd .5 .5 .5\nillum 4\n").absorption, Vec3f(0.0F)) << "clear glass";
}

TEST(Illum, TwelveTakesAnyKd) {
  const auto dark = loadMaterial("Kd 0 .5 1e-9\nillum 12\n");
  EXPECT_EQ(dark.scene.materials[0].absorption, Vec3f(1e6F, 1.0F, 1e6F));
  ASSERT_EQ(dark.report.warnings.size(), 1U);
  EXPECT_TRUE(
      anyContains(dark.report.warnings, "scene.mtl:1: material 'm': Kd 0 0.5 1e-09 of glass that absorbs"));
  const auto bright = loadMaterial("Kd 2 1 .5\nillum 12\n");
  EXPECT_EQ(bright.scene.materials[0].absorption, Vec3f(0.0F, 0.0F, 1.0F));
  ASSERT_EQ(bright.report.warnings.size(), 1U);
  EXPECT_TRUE(anyContains(bright.report.warnings, "is above 1; taken as 1, which absorbs nothing"));
}

TEST(Illum, WhatIsNotRenderedWarns) {
  struct Case {
    const char* body;
    BsdfType bsdf;
    const char* warning;
  };
  for (const Case& c :
       {Case{"illum 5\n", BsdfType::Diffuse, "scene.mtl:2: material 'm': illum 5 is unknown"},
        Case{"illum -3\n", BsdfType::Diffuse, "illum -3 is unknown"},
        Case{"Ks .9 .6 .3\nillum 11\n", BsdfType::Mirror, "taken as a mirror of Ks 0.9 0.6 0.3"}}) {
    const auto [scene, report] = loadMaterial(c.body);
    EXPECT_EQ(scene.materials[0].bsdf, c.bsdf) << c.body;
    ASSERT_EQ(report.warnings.size(), 1U) << c.body;
    EXPECT_NE(report.warnings[0].find(c.warning), std::string::npos) << report.warnings[0];
  }
  EXPECT_EQ(materialOf("Ks .9 .6 .3\nillum 11\n").reflectance, Vec3f(0.9F, 0.6F, 0.3F));
}

TEST(Colours, AreNotClamped) {
  const auto [scene, report] = loadMaterial("Kd 1.3 .4 .5\nillum 1\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3f(1.3F, 0.4F, 0.5F));
  EXPECT_TRUE(anyContains(report.warnings, "Kd 1.3 0.4 0.5 is above 1"));
}

TEST(Colours, OneNumberIsGrey) { EXPECT_EQ(materialOf("Kd .25\nillum 1\n").reflectance, Vec3f(0.25F)); }

TEST(Colours, AbsentKdIsTheFrameworksGrey) { EXPECT_EQ(materialOf("illum 1\n").reflectance, Vec3f(0.8F)); }

TEST(Keys, IgnoredOnesWarnOncePerKeyUnlessNeutral) {
  const std::string two = "mtllib scene.mtl\nusemtl a\n" + std::string(kSquare) + "usemtl b\nf 1 2 4\n";
  const auto [scene, report] =
      loadText(two, "newmtl a\nd 1.0\nTr 0\nTf 1 1 1\nPr 0\nmap_Ks a.png\nd 0.5\nglow 3\n"
                    "newmtl b\nmap_Ks b.png\nd .25\nglow 4\nnewmtl unused\nmap_bump c.png\n");
  EXPECT_EQ(countContaining(report.warnings, "map_Ks (texture of Ks): not read"), 1U);
  EXPECT_TRUE(anyContains(report.warnings, "scene.mtl:7: d (opacity)"));
  EXPECT_EQ(countContaining(report.warnings, "'glow' is no MTL key that vkpt knows"), 1U);
  EXPECT_EQ(report.warnings.size(), 3U);
}

TEST(Keys, TheTableNamesEachOnceAndReadsTheFrameworksKeys) {
  for (const MtlKey& key : kMtlKeys) {
    EXPECT_EQ(findMtlKey(key.key), &key);
    EXPECT_FALSE(key.meaning.empty());
    EXPECT_FALSE(key.mapping.empty());
  }
  for (const char* key : {"newmtl", "Ka", "Kd", "Ks", "Ni", "Ns", "illum", "Ke", "map_Kd"}) {
    EXPECT_EQ(findMtlKey(key)->use, MtlUse::Read) << key;
  }
}

TEST(Libraries, AMissingOneGivesGreyAndAWarningThatNamesIt) {
  const auto [scene, report] = loadText("mtllib none.mtl\nusemtl red\n" + std::string(kSquare));
  ASSERT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(scene.materials[0].name, "default");
  EXPECT_EQ(scene.materials[0].bsdf, BsdfType::Diffuse);
  EXPECT_EQ(scene.materials[0].reflectance, Vec3f(0.8F));
  EXPECT_EQ(scene.materials[0].emission, Vec3f(0.0F));
  EXPECT_TRUE(anyContains(report.warnings, "scene.obj:1: material file 'none.mtl' cannot be read"));
  EXPECT_TRUE(anyContains(report.warnings, "scene.obj:2: unknown material 'red'"));
}

TEST(Libraries, AnUnknownMaterialGivesGreyAndOneWarningWithTheNearest) {
  const auto [scene, report] = loadText("mtllib scene.mtl\nusemtl whit\n" + std::string(kSquare) +
                                            "usemtl white\nf 2 3 4\nusemtl whit\nf 1 2 4\n",
                                        "newmtl white\nKd .5 .5 .5\n");
  EXPECT_EQ(trianglesOf(scene, "default").size(), 3U);
  EXPECT_EQ(trianglesOf(scene, "white").size(), 1U);
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_NE(report.warnings[0].find(
                "scene.obj:2: unknown material 'whit'; taken as grey (Kd 0.8), did you mean 'white'?"),
            std::string::npos)
      << report.warnings[0];
}

TEST(Libraries, FacesWithoutAnyMaterialAreGreyInSilence) {
  const auto [scene, report] = loadText(kSquare);
  EXPECT_EQ(scene.materials.at(0).reflectance, Vec3f(0.8F));
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Libraries, AMaterialKnowsItsLine) {
  const auto [scene, report] = loadText(kUseM, "# head\r\n\r\nnewmtl other\r\nnewmtl m\r\nKd 1 0 0\r\n");
  EXPECT_TRUE(scene.materials[0].where.text().ends_with("scene.mtl:4")) << scene.materials[0].where.text();
}

TEST(Libraries, OfTwoMaterialsOfOneNameTheFirstHolds) {
  const auto [scene, report] = loadMaterial("Kd 1 0 0\nnewmtl m\nKd 0 1 0\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3f(1, 0, 0));
  EXPECT_TRUE(anyContains(report.warnings, "scene.mtl:3: material 'm' is defined again"));
}

TEST(Libraries, NamesMayHoldBlanksAndBackslashes) {
  const TempFolder folder;
  folder.write("sub/my mats.mtl", "newmtl dark red\nKd .5 0 0\n");
  folder.write("two.mtl", "newmtl two\nKd 0 .5 0\n");
  const auto [scene, report] =
      load({folder.write("scene.obj", "mtllib sub\\my mats.mtl\nmtllib none.mtl two.mtl\nusemtl dark red\n" +
                                          std::string(kSquare) + "usemtl two\nf 1 2 4\n")});
  EXPECT_EQ(materialNamed(scene, "dark red").reflectance, Vec3f(0.5F, 0, 0));
  EXPECT_EQ(materialNamed(scene, "two").reflectance, Vec3f(0, 0.5F, 0));
  EXPECT_EQ(report.warnings.size(), 1U);
}

TEST(Libraries, TwoFilesShareTheirMaterials) {
  const TempFolder folder;
  folder.write("scene.mtl", "newmtl m\nKd .5 0 0\nKs .5 1 1\nillum 2\n");
  const auto [scene, report] =
      load({folder.write("a.obj", kUseM), folder.write("b.obj", otherSquare(kUseM))});
  EXPECT_EQ(scene.triangles.size(), 4U);
  EXPECT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(report.warnings.size(), 1U) << "Ks without Ns";
}

} // namespace
} // namespace vkpt::test
