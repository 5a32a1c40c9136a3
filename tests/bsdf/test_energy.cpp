// Energy: no draw gives more than it got; surfaces that absorb nothing lose less the smoother they are, and
// smooth ones nothing at all.
#include "bsdf/sampling_checks.h"
#include "scenes/statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace vkpt::test {
namespace {

constexpr std::uint32_t kDraws = 1U << 15U;
constexpr float kAlphas[] = {1.0F, 0.5F, 0.25F, 0.1F, 0.01F, 1e-3F, 1e-4F};
constexpr double kAngles[] = {0.0, 45.0, 80.0, 89.0, 89.99};
/// A dozen roundings of numbers near 1; Beckmann's masking is as good as its erf, 1.5e-7.
constexpr double kRounding = 1e-6;

View viewAt(std::uint32_t material, double degrees, bool front) {
  const double theta = degrees * std::numbers::pi / 180.0;
  const Vec3d n = glm::normalize(Vec3d(-0.7, 0.1, -0.6));
  const Vec3d across = glm::normalize(glm::cross(n, Vec3d(0.1, 0.2, 0.9)));
  return {material, Vec3f(n * std::cos(theta) + across * std::sin(theta)), Vec3f(n), front};
}

/// A metal that absorbs nothing: an index that is imaginary.
Material losslessMetal(float alpha, MicrofacetDistribution d) {
  return roughMetal(Vec3f(0.0F), Vec3f(2.0F), alpha, d);
}

struct Reflectance {
  double mean = 0.0;
  double error = 0.0;
  double most = 0.0; ///< weight of one draw
};
Reflectance reflectanceOf(Probe& probe, const View& view, const std::string& name) {
  Reflectance r;
  double squares = 0.0;
  for (const BsdfDraw& d : probe.sampleBsdf(view, kDraws, seedOf(name))) {
    const double w = static_cast<double>(d.weight.y);
    EXPECT_TRUE(std::isfinite(w) && std::isfinite(d.pdf_w) && w >= 0.0) << name;
    r.mean += w / kDraws;
    squares += w * w / kDraws;
    r.most = std::max(r.most, w);
  }
  r.error = std::sqrt(std::max(squares - r.mean * r.mean, 0.0) / kDraws);
  return r;
}

class Furnace : public RenderTest, public testing::WithParamInterface<MicrofacetDistribution> {};

TEST_P(Furnace, RoughSurfacesLoseLessTheSmootherTheyAre) {
  std::vector<MaterialCase> materials;
  for (const float alpha : kAlphas) {
    materials.push_back({fmt::format("metal {:g}", alpha), losslessMetal(alpha, GetParam())});
    materials.push_back({fmt::format("glass {:g}", alpha), roughGlass(1.5F, alpha, GetParam())});
  }
  const Scene scene = sceneOf(materials);
  Probe probe(scene, effectsOf(scene));
  for (const double degrees : kAngles) {
    for (const std::uint32_t kind : {0U, 1U, 2U}) { // metal, glass, glass from behind
      double last = 0.0;
      for (std::uint32_t i = kind == 0 ? 0 : 1; i < materials.size(); i += 2) {
        const std::string name = fmt::format("{} at {} from {}", materials[i].name, degrees, kind);
        const Reflectance r = reflectanceOf(probe, viewAt(i, degrees, kind != 2), name);
        EXPECT_LE(r.most, 1.0 + kRounding) << name;
        // Grazing, the roughest lobes lose less than rough ones: what they mask is turned upwards.
        if (degrees <= 45.0) {
          EXPECT_GE(r.mean + 4.0 * r.error, last) << name;
        }
        last = r.mean;
      }
      // What is lost is masked: about alpha tan(theta) of it.
      const double tangent = std::tan(degrees * std::numbers::pi / 180.0);
      EXPECT_GE(last, 1.0 - kRounding - 1e-4 * tangent) << degrees << " " << kind;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Furnace,
                         testing::Values(MicrofacetDistribution::Ggx, MicrofacetDistribution::Beckmann),
                         [](const auto& test) {
                           return test.param == MicrofacetDistribution::Ggx ? "Ggx" : "Beckmann";
                         });

TEST_F(RenderTest, SmoothSurfacesLoseNothing) {
  const std::vector<MaterialCase> materials{
      {"mirror", mirror(Vec3f(1.0F))}, {"glass", glass(1.5F)}, {"metal", metal(Vec3f(0.0F), Vec3f(2.0F))}};
  const Scene scene = sceneOf(materials);
  Probe probe(scene, effectsOf(scene));
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    for (const double degrees : kAngles) {
      for (const BsdfDraw& d : probe.sampleBsdf(viewAt(i, degrees, true), 1000, 1)) {
        ASSERT_EQ(d.pdf_w, 0.0F);
        ASSERT_EQ(d.weight, Vec3f(1.0F)) << materials[i].name << " at " << degrees;
      }
    }
  }
}

TEST_F(RenderTest, CoatedSurfacesGainNothing) {
  std::vector<MaterialCase> materials;
  for (const float alpha : kAlphas) {
    materials.push_back({fmt::format("microfacet {:g}", alpha), microfacet(Vec3f(0.0F), alpha, 1.5F)});
    materials.push_back({fmt::format("base {:g}", alpha), microfacet(Vec3f(1.0F, 0.6F, 0.6F), alpha, 1.5F)});
  }
  materials.push_back({"phong", phong(Vec3f(0.5F), Vec3f(0.5F), 50.0F)});
  const Scene scene = sceneOf(materials);
  Probe probe(scene, effectsOf(scene));
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    for (const double degrees : kAngles) {
      const Reflectance r = reflectanceOf(probe, viewAt(i, degrees, true), materials[i].name);
      EXPECT_LE(r.mean, 1.0 + kRounding + 4.5 * r.error) << materials[i].name << " at " << degrees;
    }
  }
}

/// Alpha 10 is the roughest that scenes may ask for, and at 1e-4 in float a lobe is still a lobe; directions
/// a float's breadth above the surface.
TEST_F(RenderTest, NoDrawIsNotANumberWhateverTheRoughness) {
  std::vector<MaterialCase> materials;
  for (const float alpha : {1e-4F, 3e-3F, 1.0F, 10.0F}) {
    for (const auto d : {MicrofacetDistribution::Ggx, MicrofacetDistribution::Beckmann}) {
      materials.push_back({fmt::format("metal {:g}", alpha), losslessMetal(alpha, d)});
      const float blurred = std::max(alpha, 3e-4F); // below, refraction is taken for smooth
      materials.push_back({fmt::format("glass {:g}", alpha), roughGlass(1.5F, blurred, d)});
      materials.push_back({fmt::format("dense {:g}", alpha), roughGlass(1e6F, alpha, d)});
    }
    materials.push_back({fmt::format("coat {:g}", alpha), microfacet(Vec3f(0.0F), alpha, 1.5F)});
  }
  const Scene scene = sceneOf(materials);
  Probe probe(scene, effectsOf(scene));
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    for (const double height : {0.0, 1e-30, 1e-7, 1e-3, 1.0}) {
      for (const bool front : {true, false}) {
        const View view{i, Vec3f(Vec3d(std::sqrt(1.0 - height * height), 0.0, height)), Vec3f(0, 0, 1),
                        front};
        for (const BsdfDraw& d : probe.sampleBsdf(view, 4096, i)) {
          const bool finite = std::isfinite(d.pdf_w) && std::isfinite(d.weight.x) && std::isfinite(d.wi.x) &&
                              std::isfinite(d.wi.y) && std::isfinite(d.wi.z);
          ASSERT_TRUE(finite && d.weight.x >= 0.0F && (d.pdf_w > 0.0F || !d.scatters()))
              << materials[i].name << " at height " << height << " pdf " << d.pdf_w << " weight "
              << d.weight.x;
          ASSERT_NEAR(glm::length(Vec3d(d.wi)), 1.0, 1e-5);
        }
      }
    }
  }
}

} // namespace
} // namespace vkpt::test
