// Tests of BSDFs: right ones pass, wrong ones fail, and the numbers depend on the seed alone.

#include "selftest/run_tests.h"

#include <gtest/gtest.h>

#include <vector>

namespace vkpt::test {
namespace {

Material diffuse(float albedo) {
  Material m;
  m.name = "diffuse";
  m.where = {"test.xml", 7, 5};
  m.reflectance = Vec3f(albedo);
  m.twoSided = false;
  return m;
}

Material phong(float kd, float ks, float exponent) {
  Material m = diffuse(kd);
  m.name = "phong";
  m.bsdf = BsdfType::Phong;
  m.specular = Vec3f(ks);
  m.exponent = exponent;
  return m;
}

struct Results {
  SelftestCounts counts;
  std::vector<TestOutcome> outcomes;
};

Results run(const NoriTests& tests, std::uint32_t seed = 0) {
  Results results;
  results.counts = runTests(tests, seed, {}, [&](const TestOutcome& o) { results.outcomes.push_back(o); });
  return results;
}

NoriTests meansOf(std::vector<Material> bsdfs, std::vector<double> angles, std::vector<double> references) {
  NoriTTest test;
  test.where = {"test.xml", 3, 1};
  test.sampleCount = 10'000;
  test.significanceLevel = 0.001;
  test.bsdfs = std::move(bsdfs);
  test.angles = std::move(angles);
  test.references = std::move(references);
  return {{test}, {}};
}

TEST(BsdfMeans, RightReferencesPass) {
  const Results r = run(meansOf({diffuse(0.5F), phong(0.0F, 0.8F, 0.0F)}, {0.0, 60.0}, {0.5, 0.5, 0.8, 0.6}));
  EXPECT_EQ(r.counts.passed, 4U);
  EXPECT_EQ(r.counts.failed, 0U);
  EXPECT_EQ(r.outcomes.at(1).what, "diffuse at 60 degrees");
  EXPECT_EQ(r.outcomes.at(2).what, "phong at 0 degrees");
  EXPECT_EQ(r.outcomes.at(0).where.text(), "test.xml:7:5");
  EXPECT_DOUBLE_EQ(r.outcomes.at(0).level, sidakLevel(0.001, 4));
}

TEST(BsdfMeans, AWrongReferenceFailsAlone) {
  const Results r =
      run(meansOf({diffuse(0.5F), phong(0.0F, 0.8F, 0.0F)}, {0.0, 60.0}, {0.5, 0.501, 0.8, 0.65}));
  ASSERT_EQ(r.outcomes.size(), 4U);
  EXPECT_TRUE(r.outcomes[0].passed());
  EXPECT_FALSE(r.outcomes[1].passed());
  EXPECT_TRUE(r.outcomes[2].passed());
  EXPECT_FALSE(r.outcomes[3].passed());
  EXPECT_EQ(r.counts.failed, 2U);
}

TEST(BsdfMeans, LuminanceOfTheWeights) {
  Material m = diffuse(0.0F);
  m.reflectance = {1.0F, 0.5F, 0.25F};
  const double right = 0.212671 + 0.5 * 0.715160 + 0.25 * 0.072169;
  EXPECT_EQ(run(meansOf({m}, {45.0}, {right})).counts.failed, 0U);
  EXPECT_EQ(run(meansOf({m}, {45.0}, {1.75 / 3.0})).counts.failed, 1U) << "the mean of the channels";
}

TEST(BsdfMeans, TheBackIsBlackUnlessTwoSided) {
  Material m = diffuse(0.5F);
  EXPECT_EQ(run(meansOf({m}, {120.0}, {0.0})).counts.failed, 0U);
  m.twoSided = true;
  EXPECT_EQ(run(meansOf({m}, {120.0}, {0.5})).counts.failed, 0U);
}

TEST(BsdfMeans, SeedsDecideAndStreamsDiffer) {
  const NoriTests tests =
      meansOf({phong(0.3F, 0.6F, 1.0F), phong(0.3F, 0.6F, 1.0F)}, {60.0}, {0.665399, 0.665399});
  const Results first = run(tests, 1);
  const Results again = run(tests, 1);
  const Results other = run(tests, 2);
  EXPECT_EQ(first.outcomes[0].statistic.value, again.outcomes[0].statistic.value);
  EXPECT_NE(first.outcomes[0].statistic.value, other.outcomes[0].statistic.value);
  EXPECT_NE(first.outcomes[0].statistic.value, first.outcomes[1].statistic.value);
}

NoriTests directionsOf(std::vector<Material> bsdfs) {
  NoriChi2Test test;
  test.sampleCount = 50'000;
  test.significanceLevel = 0.001;
  test.testCount = 2;
  test.bsdfs = std::move(bsdfs);
  return {{}, {test}};
}

TEST(BsdfDirections, FollowTheirDensity) {
  const Results r = run(directionsOf({diffuse(0.5F), phong(0.3F, 0.6F, 30.0F)}));
  EXPECT_EQ(r.counts.passed, 4U);
  EXPECT_EQ(r.counts.failed, 0U);
  EXPECT_DOUBLE_EQ(r.outcomes.at(0).level, sidakLevel(0.001, 4));
  EXPECT_GT(r.outcomes.at(0).statistic.degrees, 90.0);
}

TEST(BsdfDirections, NeedADensity) {
  Material mirror = diffuse(1.0F);
  mirror.name = "mirror";
  mirror.bsdf = BsdfType::Mirror;
  for (const Material& m : {mirror, diffuse(0.0F)}) {
    bool ran = false;
    const auto tell = [&](const TestOutcome&) { ran = true; };
    try {
      runTests(directionsOf({diffuse(0.5F), m}), 0, {}, tell);
      FAIL() << m.name;
    } catch (const SceneError& e) {
      EXPECT_TRUE(std::string_view(e.what()).starts_with("test.xml:7:5: " + m.name + " has no density"))
          << e.what();
    }
    EXPECT_FALSE(ran) << "said before any test runs";
  }
}

TEST(Outcome, AsALine) {
  TestOutcome outcome;
  outcome.where = {"a.xml", 3, 5};
  outcome.what = "diffuse at 30 degrees";
  outcome.figures = "mean 0.5, reference 0.5";
  outcome.statistic.name = "t";
  outcome.statistic.value = 0.25;
  outcome.statistic.degrees = 99.0;
  outcome.statistic.p = 0.8;
  outcome.level = 0.01;
  EXPECT_EQ(outcomeText(outcome),
            "pass a.xml:3:5: diffuse at 30 degrees: mean 0.5, reference 0.5; t 0.25 with 99 "
            "degrees of freedom, p 0.8, passes above 0.01");
  outcome.statistic.p = 0.005;
  EXPECT_TRUE(outcomeText(outcome).starts_with("FAIL a.xml:3:5: "));
  outcome.statistic.p = 0.8;
  outcome.statistic.why = "2 faults";
  EXPECT_EQ(outcomeText(outcome), "FAIL a.xml:3:5: diffuse at 30 degrees: mean 0.5, reference 0.5; 2 faults");
}

} // namespace
} // namespace vkpt::test
