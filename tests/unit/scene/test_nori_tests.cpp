// Nori's files of tests, as data.

#include "unit/scene/nori_check.h"

#include "scene/nori_tests.h"

#include <gtest/gtest.h>

namespace vkpt::test {
namespace {

class NoriTestFile : public testing::Test {
protected:
  NoriTests load(std::string_view xml) { return loadNoriTests(m_folder.write("test.xml", xml), m_report); }

  std::string error(std::string_view xml) {
    try {
      load(xml);
    } catch (const SceneError& e) {
      return std::string(e.what()).substr(m_folder.path().string().size() + 1);
    }
    return {};
  }

  NoriFolder m_folder;
  SceneReport m_report;
};

TEST_F(NoriTestFile, ChiSquaredTestWithItsDefaults) {
  const NoriTests tests = load("<test type='chi2test'><bsdf type='microfacet'/></test>");
  EXPECT_TRUE(tests.tTests.empty());
  ASSERT_EQ(tests.chi2Tests.size(), 1U);
  const NoriChi2Test& test = tests.chi2Tests[0];
  EXPECT_EQ(test.significanceLevel, 0.01);
  EXPECT_EQ(test.resolution, 10);
  EXPECT_EQ(test.minExpFrequency, 5);
  EXPECT_EQ(test.sampleCount, 1000000);
  EXPECT_EQ(test.testCount, 5);
  ASSERT_EQ(test.bsdfs.size(), 1U);
  EXPECT_EQ(test.bsdfs[0].bsdf, BsdfType::Microfacet);
  EXPECT_EQ(test.where.line, 1U);
}

TEST_F(NoriTestFile, ChiSquaredTestWithItsParameters) {
  const NoriTests tests = load(R"(<scene><test type="chi2test"><float name="significanceLevel" value=".05"/>
    <integer name="resolution" value="20"/><integer name="minExpFrequency" value="6"/>
    <integer name="testCount" value="7"/><bsdf type="diffuse"/><bsdf type="phong"/></test>
    <test type="chi2test"><integer name="sampleCount" value="123"/><bsdf type="diffuse"/></test></scene>)");
  ASSERT_EQ(tests.chi2Tests.size(), 2U);
  const NoriChi2Test& test = tests.chi2Tests[0];
  EXPECT_EQ(test.significanceLevel, 0.05);
  EXPECT_EQ(test.resolution, 20);
  EXPECT_EQ(test.minExpFrequency, 6);
  EXPECT_EQ(test.testCount, 7);
  EXPECT_EQ(test.sampleCount, 4000000) << "5000 for each of 20 x 40 cells";
  EXPECT_EQ(test.bsdfs.size(), 2U);
  EXPECT_EQ(tests.chi2Tests[1].sampleCount, 123);
}

TEST_F(NoriTestFile, TTestOfBsdfs) {
  const NoriTests tests = load(R"(<test type="ttest"><string name="angles" value="0, 30 60"/>
    <string name="references" value=".1, .2, .3, 1e-1 2e-1 3e-1"/>
    <bsdf type="diffuse"/><bsdf type="microfacet"/></test>)");
  ASSERT_EQ(tests.tTests.size(), 1U);
  const NoriTTest& test = tests.tTests[0];
  EXPECT_EQ(test.significanceLevel, 0.01);
  EXPECT_EQ(test.sampleCount, 100000);
  EXPECT_EQ(test.angles, (std::vector<double>{0, 30, 60}));
  EXPECT_EQ(test.references, (std::vector<double>{.1, .2, .3, .1, .2, .3}));
  ASSERT_EQ(test.bsdfs.size(), 2U);
  EXPECT_EQ(test.bsdfs[1].bsdf, BsdfType::Microfacet);
  EXPECT_TRUE(test.scenes.empty());
}

TEST_F(NoriTestFile, TTestOfScenes) {
  const std::string scene = noriScene("<integrator type='direct_ems'/>");
  const NoriTests tests =
      load("<test type='ttest'><string name='references' value='.5 .25'/>"
           "<integer name='sampleCount' value='1000'/><float name='significanceLevel' value='.001'/>" +
           scene + noriScene("<integrator type='path'/>") + "</test>");
  const NoriTTest& test = tests.tTests.at(0);
  EXPECT_EQ(test.sampleCount, 1000);
  EXPECT_EQ(test.significanceLevel, 0.001);
  ASSERT_EQ(test.scenes.size(), 2U);
  EXPECT_EQ(test.scenes[0].defaults.light, LightStrategy::Nee);
  EXPECT_FALSE(test.scenes[1].defaults.light);
  EXPECT_EQ(test.scenes[1].triangles.size(), 2U);
  EXPECT_EQ(countContaining(m_report.notes, "Nori conventions"), 1U) << "said once";
}

TEST_F(NoriTestFile, WhatStandsBesideTestsIsWarnedAbout) {
  load("<scene><test type='chi2test'><bsdf type='diffuse'/></test>\n<bsdf type='mirror'/></scene>");
  EXPECT_TRUE(anyContains(m_report.warnings, "test.xml:2:1: <bsdf> beside tests is ignored"));
}

TEST_F(NoriTestFile, Errors) {
  EXPECT_EQ(error(noriScene("")), "test.xml:1:1: no <test> in the file; vkpt " +
                                      (m_folder.path() / "test.xml").string() + " renders a scene");
  EXPECT_EQ(error("<test type='ttests'/>"),
            "test.xml:1:1: unknown test type 'ttests'; vkpt knows ttest, chi2test, did you mean 'ttest'?");
  EXPECT_EQ(error("<test type='ttest'/>"), "test.xml:1:1: a test of nothing; give it a <bsdf> or a <scene>");
  EXPECT_EQ(error("<test type='chi2test'/>"), "test.xml:1:1: a test of nothing; give it a <bsdf>");
  EXPECT_EQ(error("<test type='ttest'><bsdf type='diffuse'/><scene/></test>"),
            "test.xml:1:1: a test of bsdfs and scenes; make it two tests");
  EXPECT_EQ(error("<test type='ttest'><bsdf type='diffuse'/></test>"),
            "test.xml:1:1: a test of bsdfs without angles; give those of incidence, in degrees");
  EXPECT_EQ(error("<test type='ttest'>\n<string name='references' value='1 2'/>"
                  "<string name='angles' value='0 30 60'/><bsdf type='diffuse'/></test>"),
            "test.xml:2:1: references: 2 numbers; give 3, one for each angle of each bsdf");
  EXPECT_EQ(error("<test type='ttest'>\n<string name='references' value='1 2'/>" + noriScene("") + "</test>"),
            "test.xml:2:1: references: 2 numbers; give 1, one for each scene");
  EXPECT_EQ(error("<test type='ttest'>\n<string name='references' value='one'/>" + noriScene("") + "</test>"),
            "test.xml:2:1: references: 'one' is no number");
  EXPECT_EQ(error("<test type='chi2test'>\n<float name='significanceLevel' value='1'/>"
                  "<bsdf type='diffuse'/></test>"),
            "test.xml:2:1: significanceLevel is 1; give more than 0 and less than 1");
  EXPECT_EQ(error("<test type='chi2test'>\n<scene/></test>").substr(0, 39),
            "test.xml:2:1: misplaced <scene> in test");
}

TEST_F(NoriTestFile, HasToBeXml) {
  EXPECT_THROW(loadNoriTests(m_folder.path() / "square.obj", m_report), SceneError);
  EXPECT_THROW(loadNoriTests(m_folder.path() / "gone.xml", m_report), SceneError);
}

} // namespace
} // namespace vkpt::test
