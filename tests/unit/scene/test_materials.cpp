#include "unit/scene/scene_check.h"

#include "scene/mtl_table.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

const std::string kUse = "mtllib scene.mtl\nusemtl m\n" + std::string(kSquare);

Loaded loadMaterial(const std::string& body) { return loadText(kUse, "newmtl m\n" + body); }
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

TEST(Illum, WhatIsNotRenderedYetWarns) {
  struct Case {
    const char* body;
    BsdfType bsdf;
    const char* warning;
  };
  for (const Case& c :
       {Case{"Ks .5 .5 .5\nillum 2\n", BsdfType::Diffuse, "scene.mtl:3: material 'm': illum 2 with Ks"},
        Case{"illum 12\nNi 1.335\n", BsdfType::Dielectric, "scene.mtl:2: material 'm': illum 12 absorbs"},
        Case{"illum 5\n", BsdfType::Diffuse, "scene.mtl:2: material 'm': illum 5 is unknown"},
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
  const std::string two = "mtllib scene.mtl\nusemtl a\n" + std::string(kSquare) + "usemtl b\nf 1 2 3\n";
  const auto [scene, report] =
      loadText(two, "newmtl a\nd 1.0\nTr 0\nTf 1 1 1\nPr 0\nmap_Kd a.png\nd 0.5\nglow 3\n"
                    "newmtl b\nmap_Kd b.png\nd .25\nglow 4\nnewmtl unused\nmap_bump c.png\n");
  EXPECT_EQ(countContaining(report.warnings, "map_Kd (texture of Kd): not read"), 1U);
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
  for (const char* key : {"newmtl", "Ka", "Kd", "Ks", "Ni", "illum", "Ke"}) {
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
                                            "usemtl white\nf 1 2 3\nusemtl whit\nf 1 2 4\n",
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
  const auto [scene, report] = loadText(kUse, "# head\r\n\r\nnewmtl other\r\nnewmtl m\r\nKd 1 0 0\r\n");
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
                                          std::string(kSquare) + "usemtl two\nf 1 2 3\n")});
  EXPECT_EQ(materialNamed(scene, "dark red").reflectance, Vec3f(0.5F, 0, 0));
  EXPECT_EQ(materialNamed(scene, "two").reflectance, Vec3f(0, 0.5F, 0));
  EXPECT_EQ(report.warnings.size(), 1U);
}

TEST(Libraries, TwoFilesShareTheirMaterials) {
  const TempFolder folder;
  folder.write("scene.mtl", "newmtl m\nKd .5 0 0\nKs 1 1 1\nillum 2\n");
  const auto [scene, report] = load({folder.write("a.obj", kUse), folder.write("b.obj", kUse)});
  EXPECT_EQ(scene.triangles.size(), 4U);
  EXPECT_EQ(scene.materials.size(), 1U);
  EXPECT_EQ(report.warnings.size(), 1U);
}

} // namespace
} // namespace vkpt::test
