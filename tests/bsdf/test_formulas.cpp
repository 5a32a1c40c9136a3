// The BSDFs against their papers' formulas, written here a second time and in the papers' own terms;
// reciprocity.
#include "bsdf/sampling_checks.h"

#include <cmath>
#include <numbers>
#include <random>

namespace vkpt::test {
namespace {

using std::numbers::pi;

/// Directions to compare at: `count` pairs above the surface, or with wi below it.
struct Pair {
  Vec3d wo, wi;
};
std::vector<Pair> pairs(const Vec3d& n, bool below, int count) {
  std::mt19937 random(seedOf(currentTestName()));
  std::normal_distribution<double> normal;
  const auto direction = [&](bool under) {
    const Vec3d d = glm::normalize(Vec3d(normal(random), normal(random), normal(random)));
    return (glm::dot(d, n) < 0.0) == under ? d : -d;
  };
  std::vector<Pair> result;
  for (int i = 0; i < count; ++i) {
    const Vec3d wo = direction(false);
    result.push_back({wo, direction(below)});
  }
  return result;
}

struct Angles {
  double cosine, tangent2;
  Angles(const Vec3d& n, const Vec3d& w)
      : cosine(std::abs(glm::dot(n, w))), tangent2((1.0 - cosine * cosine) / (cosine * cosine)) {}
};

double distribution(bool beckmann, double alpha, const Angles& h) { // Walter et al. 2007, eq. 25 and 33
  const double a2 = alpha * alpha;
  const double c4 = std::pow(h.cosine, 4);
  return beckmann ? std::exp(-h.tangent2 / a2) / (pi * a2 * c4)
                  : a2 / (pi * c4 * (a2 + h.tangent2) * (a2 + h.tangent2));
}
double lambda(bool beckmann, double alpha, const Angles& w) { // Heitz 2014, eq. 68 and 72
  const double a = 1.0 / (alpha * std::sqrt(w.tangent2));
  return beckmann ? 0.5 * (std::exp(-a * a) / (a * std::sqrt(pi)) - std::erfc(a))
                  : 0.5 * (std::sqrt(1.0 + 1.0 / (a * a)) - 1.0);
}
double correlated(bool beckmann, double alpha, const Angles& o, const Angles& i) { // Heitz 2014, eq. 99
  return 1.0 / (1.0 + lambda(beckmann, alpha, o) + lambda(beckmann, alpha, i));
}

const std::vector<MaterialCase>& rough() {
  static const std::vector<MaterialCase> materials = [] {
    std::vector<MaterialCase> m;
    for (const float alpha : {0.05F, 0.3F, 1.0F}) {
      for (const auto d : {MicrofacetDistribution::Ggx, MicrofacetDistribution::Beckmann}) {
        m.push_back({"metal", roughMetal(Vec3f(0.2F, 0.5F, 1.5F), Vec3f(4.0F, 2.0F, 0.5F), alpha, d)});
        m.push_back({"glass", roughGlass(1.5F, alpha, d)});
      }
      m.push_back({"coat", microfacet(Vec3f(0.2F, 0.1F, 0.4F), alpha, 1.5F)});
    }
    m.push_back({"phong", phong(Vec3f(0.3F), Vec3f(0.5F), 30.0F)});
    return m;
  }();
  return materials;
}

struct Formulas : RenderTest {
  Scene scene = sceneOf(rough());
  PackedScene packed = packScene(scene, {}, 1);
  Oracle oracle{packed, {}, effectsOf(scene)};
  Vec3f n32 = glm::normalize(Vec3f(0.3F, -0.5F, 0.8F));
  Vec3d n = glm::normalize(Vec3d(n32));

  template<class F>
  void forAll(BsdfType type, const F& check) const {
    for (std::uint32_t i = 0; i < rough().size(); ++i) {
      const Material& m = rough()[i].material;
      if (m.bsdf == type)
        check(m, View{i, Vec3f(n32), n32, true}, m.distribution == MicrofacetDistribution::Beckmann,
              static_cast<double>(m.roughness));
    }
  }
};

/// The library's erf is good to 1.5e-7, its inverse has no part in values.
constexpr double kRelative = 1e-6;
constexpr double kLeast = 1e-290; // below it doubles get coarser

TEST_F(Formulas, RoughMetal) { // Walter et al. 2007, eq. 20
  forAll(BsdfType::RoughConductor, [&](const Material& m, const View& view, bool beckmann, double alpha) {
    for (const auto& [wo, wi] : pairs(n, false, 500)) {
      const Vec3d h = glm::normalize(wo + wi);
      const Angles o(n, wo);
      const Angles i(n, wi);
      const double value = distribution(beckmann, alpha, Angles(n, h)) * correlated(beckmann, alpha, o, i) /
                           (4.0 * o.cosine * i.cosine);
      for (int c = 0; c < 3; ++c) {
        const double f = value * exactFresnelConductor(glm::dot(wo, h), static_cast<double>(m.eta[c]),
                                                       static_cast<double>(m.k[c]));
        ASSERT_NEAR(oracle.evaluate(view, wo, wi).f[c], f, kRelative * f + kLeast) << alpha << beckmann;
      }
      // Density of visible normals, G1 D (wo . h) / cos, over 4 (wo . h): Heitz 2014, eq. 2; Walter, eq. 14.
      const double pdf =
          distribution(beckmann, alpha, Angles(n, h)) / (1.0 + lambda(beckmann, alpha, o)) / (4.0 * o.cosine);
      ASSERT_NEAR(oracle.evaluate(view, wo, wi).pdf_w, pdf, kRelative * pdf + kLeast) << alpha << beckmann;
    }
  });
}

TEST_F(Formulas, RoughGlassReflectsAndRefracts) { // Walter et al. 2007, eq. 16, 17, 20, 21
  forAll(BsdfType::RoughDielectric, [&](const Material& m, View view, bool beckmann, double alpha) {
    for (const bool front : {true, false}) {
      view.front = front;
      const double m32 = static_cast<double>(m.intIor / m.extIor);
      const double eta = front ? m32 : 1.0 / m32;
      for (const auto& [wo, wi] : pairs(n, false, 500)) {
        const Vec3d h = glm::normalize(wo + wi);
        const double f = exactFresnelDielectric(glm::dot(wo, h), eta) *
                         distribution(beckmann, alpha, Angles(n, h)) *
                         correlated(beckmann, alpha, Angles(n, wo), Angles(n, wi)) /
                         (4.0 * Angles(n, wo).cosine * Angles(n, wi).cosine);
        ASSERT_NEAR(oracle.evaluate(view, wo, wi).f.x, f, kRelative * f + kLeast)
            << alpha << beckmann << front;
      }
      int refracted = 0;
      for (const auto& [wo, wi] : pairs(n, true, 500)) {
        Vec3d h = -glm::normalize(wo + eta * wi); // eq. 16, divided by the index on wo's side
        h = glm::dot(h, n) < 0.0 ? -h : h;
        const double f32 = oracle.evaluate(view, wo, wi).f.x;
        if (glm::dot(wo, h) <= 0.0 || glm::dot(wi, h) >= 0.0) {
          ASSERT_EQ(f32, 0.0);
          continue;
        }
        const double across = glm::dot(wo, h) + eta * glm::dot(wi, h);
        const double f = std::abs(glm::dot(wo, h) * glm::dot(wi, h)) /
                         (Angles(n, wo).cosine * Angles(n, wi).cosine) * eta * eta *
                         (1.0 - exactFresnelDielectric(glm::dot(wo, h), eta)) *
                         distribution(beckmann, alpha, Angles(n, h)) *
                         correlated(beckmann, alpha, Angles(n, wo), Angles(n, wi)) / (across * across);
        ASSERT_NEAR(f32, f, kRelative * f + kLeast) << alpha << beckmann << front;
        ++refracted;
      }
      EXPECT_GT(refracted, 100);
    }
  });
}

TEST_F(Formulas, NorisMicrofacet) {
  const auto g1 = [](double alpha, const Angles& w) { // Walter et al. 2007: the fit of eq. 27
    const double b = 1.0 / (alpha * std::sqrt(w.tangent2));
    return b < 1.6 ? (3.535 * b + 2.181 * b * b) / (1.0 + 2.276 * b + 2.577 * b * b) : 1.0;
  };
  forAll(BsdfType::Microfacet, [&](const Material& m, const View& view, bool, double alpha) {
    for (const auto& [wo, wi] : pairs(n, false, 500)) {
      const Vec3d h = glm::normalize(wo + wi);
      const Angles o(n, wo);
      const Angles i(n, wi);
      const double coat = distribution(true, alpha, Angles(n, h)) *
                          exactFresnelDielectric(glm::dot(wi, h), static_cast<double>(m.intIor / m.extIor)) *
                          g1(alpha, o) * g1(alpha, i) / (4.0 * o.cosine * i.cosine);
      for (int c = 0; c < 3; ++c) {
        const double f =
            static_cast<double>(m.reflectance[c]) / pi + static_cast<double>(m.specular[c]) * coat;
        ASSERT_NEAR(oracle.evaluate(view, wo, wi).f[c], f, kRelative * f + kLeast) << alpha;
      }
    }
  });
}

TEST_F(Formulas, ReflectionIsReciprocal) {
  for (std::uint32_t i = 0; i < rough().size(); ++i) {
    for (const bool front : {true, false}) {
      const View view{i, n32, n32, front};
      for (const auto& [wo, wi] : pairs(n, false, 300)) {
        const Vec3d f = oracle.evaluate(view, wo, wi).f;
        ASSERT_LE(glm::length(f - oracle.evaluate(view, wi, wo).f), 1e-12 * glm::length(f))
            << rough()[i].name;
      }
    }
  }
}

/// Radiance is not scaled: what comes from the denser side lacks the square of the index (Veach 1997, 5.2).
TEST_F(Formulas, RefractionIsReciprocalUpToTheSquareOfTheIndex) {
  forAll(BsdfType::RoughDielectric, [&](const Material& m, const View& front, bool, double) {
    View back = front;
    back.n = -front.n;
    back.front = false;
    const double index = static_cast<double>(m.intIor / m.extIor);
    int compared = 0;
    for (const auto& [wo, wi] : pairs(n, true, 500)) {
      const double in = oracle.evaluate(front, wo, wi).f.x;
      const double out = oracle.evaluate(back, wi, wo).f.x;
      ASSERT_NEAR(in, index * index * out, 1e-9 * in + kLeast);
      compared += in > 0.0 ? 1 : 0;
    }
    EXPECT_GT(compared, 40);
  });
}

} // namespace
} // namespace vkpt::test
